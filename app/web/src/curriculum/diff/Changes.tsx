import type {CurriculumDiff} from '../../wire/types';

const bumps = {
  none: 'Nothing that counts was changed.', patch: 'Words only: a new patch version, as in 1.0.1.',
  minor: 'A new minor version, as in 1.1.0: scores stay comparable.', major: 'A new major version, as in 2.0.0: scores are no longer comparable.',
};
const weights = {patch: 'Words', minor: 'Minor', major: 'Major'};

/** What changed in sentences, and which step of the version that asks for. */
export function Changes({diff}: {diff: CurriculumDiff}) {
  return (
    <div className="stack">
      <p className="small"><strong>{bumps[diff.needed_bump]}</strong></p>
      {diff.changes.length > 0 && (
        <ul className="stack">
          {diff.changes.map((change, index) => <li key={index} className="small"><span className="tag">{weights[change.weight]}</span> {change.sentence}</li>)}
        </ul>
      )}
    </div>
  );
}
