export function Briefing({exerciseId}: {exerciseId: string}) { return <h1>{exerciseId}</h1>; }
