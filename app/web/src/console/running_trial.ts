// One console's hold on the running trial: the channel, what is known, and the hand. No drawing.
import {HandleSender} from './handle_sender';
import {LiveChannel} from './live_channel';
import {TrialStore} from './trial_store';

export class RunningTrial {
  readonly store = new TrialStore();
  readonly hand: HandleSender;
  private readonly channel: LiveChannel;
  private opening: ReturnType<typeof setTimeout> | undefined;

  constructor(readonly trialId: string) {
    const {store} = this;
    this.channel = new LiveChannel(trialId, {
      frame: (frame) => store.frame(frame),
      connection: (connection) => store.connection(connection),
      latency: (latency_ms) => store.latency(latency_ms),
      filed: () => store.filed(),
      problem: (message) => store.problem(message),
    });
    this.hand = new HandleSender((message) => this.channel.handle(message));
  }

  /** Opens the channel in a moment: a page that is mounted twice at once must not seem two tabs. */
  start(): void {
    clearTimeout(this.opening);
    this.opening = setTimeout(() => this.channel.open(), 0);
  }

  stop(): void {
    clearTimeout(this.opening);
    this.hand.release();
    this.hand.dispose();
    this.channel.close();
    this.store.dispose();
  }

  tryAgain(): void {
    this.channel.open();
  }

  pause(): void {
    this.hand.release();
    this.channel.control('pause');
  }

  resume(): void {
    this.channel.control('resume');
  }

  end(): void {
    this.hand.release();
    this.channel.control('end');
  }
}
