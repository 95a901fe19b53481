import {Loaded} from '../parts/Loaded';
import {ProgressSections} from '../parts/ProgressSections';
import {useResource} from '../parts/api';
import {formatCount} from '../parts/format';
import {useTitle} from '../parts/use_title';

/** Am I getting better? */
export function Progress() {
  useTitle('My progress');
  const resource = useResource('progress me', (api) => api.progress('me'));
  return (
    <Loaded resource={resource} what="your progress">
      {({person, exercises}) => (
        <>
          <div className="page-head">
            <h1>My progress</h1>
            <span className="muted num">{formatCount(person.trials, 'trial')} so far</span>
          </div>
          <ProgressSections exercises={exercises} own />
        </>
      )}
    </Loaded>
  );
}
