export default function ConsolePage({trialId}: {trialId: string}) {
  return <main className="page"><h1>Trial {trialId}</h1></main>;
}
