// The live channel of one trial: frames in, commands out. Measures the way there and back each
// second, and comes back by itself when the line drops; the server has paused the trial by then.
import {decodeFrame, type Frame} from '../wire/frame';
import type {ClientMessage, ControlMessage, HandleMessage, LiveMine, ServerNotice} from '../wire/types';

export type Connection =
  | 'connecting'
  | 'open'
  | 'lost'        // trying again
  | 'second_tab'  // another tab steers this trial
  | 'gone'        // the trial is not running any more
  | 'signed_out'
  | 'closed';     // by this page

export interface ChannelListener {
  frame(frame: Frame): void;
  connection(connection: Connection): void;
  latency(latency_ms: number): void;
  filed(trialId: string): void;
  problem(message: string): void;
}

const pingInterval_ms = 1000;
const openingLimit_ms = 5000;   // a connection that takes longer is given up and tried anew
const silentPings = 4;            // so many without a pong or a frame: the line is dead
const retryDelays_ms = [250, 500, 1000, 2000, 4000];
const handover_ms = 15_000;     // how long the server may still believe in our own lost line

export class LiveChannel {
  private socket: WebSocket | null = null;
  private retries = 0;
  private retryTimer: ReturnType<typeof setTimeout> | undefined;
  private openingTimer: ReturnType<typeof setTimeout> | undefined;
  private pingTimer: ReturnType<typeof setInterval> | undefined;
  private unheard = 0;
  private newest: ArrayBuffer | null = null;
  private decodeTimer: ReturnType<typeof setTimeout> | undefined;
  private lost_ms = -Infinity;
  private state: Connection = 'connecting';

  constructor(
    private readonly trialId: string,
    private readonly listener: ChannelListener,
  ) {}

  /** Opens the channel, now; also after a second tab was reported. */
  open(): void {
    this.abandon();
    this.enter(this.lost_ms > -Infinity ? 'lost' : 'connecting');
    const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
    const socket = new WebSocket(`${scheme}://${location.host}/api/live/${encodeURIComponent(this.trialId)}`);
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => this.opened();
    socket.onmessage = (event: MessageEvent<ArrayBuffer | string>) => this.received(event.data);
    socket.onclose = () => this.dropped();
    this.socket = socket;
    this.openingTimer = setTimeout(() => this.dropped(), openingLimit_ms);
  }

  /** Closes for good. */
  close(): void {
    this.abandon();
    this.enter('closed');
  }

  /** False when the line is down. */
  handle(message: HandleMessage): boolean {
    return this.send(message);
  }

  control(type: ControlMessage['type']): boolean {
    return this.send({type});
  }

  private send(message: ClientMessage): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  private opened(): void {
    clearTimeout(this.openingTimer);
    this.unheard = 0;
    this.enter('open');
    this.ping();
    this.pingTimer = setInterval(() => this.ping(), pingInterval_ms);
  }

  // Counts pings instead of seconds: a browser that was busy for some seconds finds what came
  // meanwhile before the next ping, and its line is not dead.
  private ping(): void {
    this.unheard += 1;
    if (this.unheard > silentPings) this.dropped();
    else this.send({type: 'ping', sent_ms: performance.now()});
  }

  private received(data: ArrayBuffer | string): void {
    this.unheard = 0;
    if (typeof data === 'string') {
      this.attempt(() => this.noticed(JSON.parse(data) as ServerNotice));
    } else {
      // where frames have piled up only the newest is worth the work
      this.newest = data;
      this.decodeTimer ??= setTimeout(() => this.decode(), 0);
    }
  }

  private decode(): void {
    this.decodeTimer = undefined;
    const bytes = this.newest;
    this.newest = null;
    if (!bytes) return;
    this.attempt(() => {
      const frame = decodeFrame(bytes);
      this.retries = 0;
      this.listener.frame(frame);
    });
  }

  private attempt(read: () => void): void {
    try {
      read();
    } catch (error) {
      this.listener.problem(error instanceof Error ? error.message : 'The server sent something unreadable.');
    }
  }

  private noticed(notice: ServerNotice): void {
    switch (notice.type) {
      case 'pong':
        this.listener.latency(performance.now() - notice.sent_ms);
        break;
      case 'filed':
        this.listener.filed(notice.trial_id);
        break;
      case 'second_tab':
        this.refusedAsSecond();
        break;
      case 'error':
        this.listener.problem(notice.message);
        break;
    }
  }

  // Right after a lost line the other "tab" is our own old connection: try again until it is gone.
  private refusedAsSecond(): void {
    const ownGhost = performance.now() - this.lost_ms < handover_ms;
    if (ownGhost) {
      this.abandon();
      this.enter('lost');
      this.retryLater();
    } else {
      this.enter('second_tab');  // and keeps watching
    }
  }

  private dropped(): void {
    const wasOpen = this.state === 'open' || this.state === 'second_tab';
    this.abandon();
    if (wasOpen) this.lost_ms = performance.now();
    this.enter(wasOpen || this.lost_ms > -Infinity ? 'lost' : 'connecting');
    void this.lookFor();
  }

  // A socket that is refused does not say why; the page asks whether there is still a trial to join.
  private async lookFor(): Promise<void> {
    let found: Connection | null = null;
    try {
      const answer = await fetch('/api/live/mine', {headers: {Accept: 'application/json'}});
      if (answer.status === 401) found = 'signed_out';
      else if (answer.ok) {
        const mine = (await answer.json()) as LiveMine;
        if (mine.trial?.trial_id !== this.trialId) found = 'gone';
      }
    } catch {
      // no answer at all: the network or the server is away, so wait
    }
    if (this.state === 'closed' || this.socket) return;
    if (found) this.enter(found);
    else this.retryLater();
  }

  private retryLater(): void {
    const delay_ms = retryDelays_ms[Math.min(this.retries, retryDelays_ms.length - 1)];
    this.retries += 1;
    clearTimeout(this.retryTimer);
    this.retryTimer = setTimeout(() => this.open(), delay_ms);
  }

  private abandon(): void {
    clearTimeout(this.retryTimer);
    clearTimeout(this.openingTimer);
    clearInterval(this.pingTimer);
    clearTimeout(this.decodeTimer);
    this.decodeTimer = undefined;
    this.newest = null;
    const socket = this.socket;
    this.socket = null;
    if (!socket) return;
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.close();
  }

  private enter(state: Connection): void {
    if (state === this.state) return;
    this.state = state;
    this.listener.connection(state);
  }
}
