export function Debrief({trialId}: {trialId: string}) { return <h1>{trialId}</h1>; }
