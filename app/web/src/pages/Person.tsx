export function Person({personId}: {personId: string}) { return <h1>{personId}</h1>; }
