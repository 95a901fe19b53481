export function Help({version}: {version: string}) { return <h1>{version}</h1>; }
