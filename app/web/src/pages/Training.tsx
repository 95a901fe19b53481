export function Training() { return <h1>Training</h1>; }
