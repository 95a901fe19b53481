import {afterEach, beforeEach, describe, expect, it, vi} from 'vitest';
import {frameHeaderSize, frameMagic, frameVersion} from '../wire/frame';
import {type ChannelListener, type Connection, LiveChannel} from './live_channel';

class FakeSocket {
  static all: FakeSocket[] = [];
  static readonly OPEN = 1;
  readyState = 0;
  binaryType = '';
  sent: string[] = [];
  onopen: (() => void) | null = null;
  onclose: (() => void) | null = null;
  onmessage: ((event: {data: unknown}) => void) | null = null;
  constructor(readonly url: string) {
    FakeSocket.all.push(this);
  }
  send(text: string) {
    this.sent.push(text);
  }
  close() {
    this.readyState = 3;
  }
  accept() {
    this.readyState = 1;
    this.onopen?.();
  }
  fail() {
    this.readyState = 3;
    this.onclose?.();
  }
  say(notice: object) {
    this.onmessage?.({data: JSON.stringify(notice)});
  }
}

const newest = () => FakeSocket.all[FakeSocket.all.length - 1] as FakeSocket;
const connections: Connection[] = [];
const filed: string[] = [];
const problems: string[] = [];
let frames = 0;
const listener: ChannelListener = {
  frame: () => { frames += 1; },
  connection: (connection) => connections.push(connection),
  latency: () => undefined,
  filed: (trialId) => filed.push(trialId),
  problem: (message) => problems.push(message),
};
let mine: {status: number; trialId: string | null};
let channel: LiveChannel;

beforeEach(() => {
  vi.useFakeTimers();
  FakeSocket.all = [];
  [connections, filed, problems].forEach((list) => list.splice(0));
  frames = 0;
  mine = {status: 200, trialId: 't-1'};
  vi.stubGlobal('WebSocket', FakeSocket);
  vi.stubGlobal('location', {protocol: 'http:', host: 'here'});
  vi.stubGlobal('fetch', () => Promise.resolve({
    ok: mine.status === 200,
    status: mine.status,
    json: () => Promise.resolve({trial: mine.trialId === null ? null : {trial_id: mine.trialId}}),
  }));
  channel = new LiveChannel('t-1', listener);
  channel.open();
});
afterEach(() => {
  channel.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

describe('the live channel', () => {
  it('opens at the trial, pings each second and sends only while the line holds', () => {
    expect(newest().url).toBe('ws://here/api/live/t-1');
    expect(channel.control('resume')).toBe(false);
    newest().accept();
    expect(connections).toEqual(['open']);
    vi.advanceTimersByTime(3000);
    const types = newest().sent.map((text) => (JSON.parse(text) as {type: string}).type);
    expect(types).toEqual(['ping', 'ping', 'ping', 'ping']);
    expect(channel.control('resume')).toBe(true);
  });

  it('passes on whole frames, and says when one cannot be read', () => {
    newest().accept();
    const header = new DataView(new ArrayBuffer(frameHeaderSize));
    header.setUint32(0, frameMagic, true);
    header.setUint16(4, frameVersion, true);
    newest().onmessage?.({data: header.buffer});
    vi.advanceTimersByTime(1);
    expect(frames).toBe(1);
    newest().onmessage?.({data: new ArrayBuffer(7)});
    newest().onmessage?.({data: '{broken'});
    vi.advanceTimersByTime(1);
    expect(frames).toBe(1);
    expect(problems).toHaveLength(2);
  });

  it('reads only the newest of frames that have piled up', () => {
    newest().accept();
    const header = new DataView(new ArrayBuffer(frameHeaderSize));
    header.setUint32(0, frameMagic, true);
    header.setUint16(4, frameVersion, true);
    for (let i = 0; i < 100; ++i) newest().onmessage?.({data: header.buffer});
    vi.advanceTimersByTime(1);
    expect(frames).toBe(1);
  });

  it('comes back by itself after a lost line, with longer and longer pauses', async () => {
    newest().accept();
    newest().fail();
    expect(connections).toEqual(['open', 'lost']);
    for (const [pause_ms, sockets] of [[250, 2], [500, 3], [1000, 4]] as const) {
      await vi.advanceTimersByTimeAsync(pause_ms - 10);
      expect(FakeSocket.all).toHaveLength(sockets - 1);
      await vi.advanceTimersByTimeAsync(20);
      expect(FakeSocket.all).toHaveLength(sockets);
      newest().fail();
    }
    await vi.advanceTimersByTimeAsync(2100);
    newest().accept();
    expect(connections).toEqual(['open', 'lost', 'open']);
  });

  it('notices a line that fell silent', async () => {
    newest().accept();
    await vi.advanceTimersByTimeAsync(6000);
    expect(connections).toContain('lost');
  });

  it('does not take a busy browser for a dead line', () => {
    newest().accept();
    const socket = newest();
    vi.advanceTimersByTime(1500);
    // ten seconds in which nothing ran; the timer fires once, then what had come is read
    vi.setSystemTime(Date.now() + 10_000);
    vi.advanceTimersByTime(500);
    socket.say({type: 'pong', sent_ms: 0});
    vi.advanceTimersByTime(3000);
    expect(connections).toEqual(['open']);
  });

  it('gives up an attempt that gets no answer', async () => {
    await vi.advanceTimersByTimeAsync(6000);
    expect(FakeSocket.all.length).toBeGreaterThan(1);
  });

  it('says when another tab steers, keeps watching, and does not fight for the wheel', async () => {
    newest().accept();
    newest().say({type: 'second_tab', message: 'another tab'});
    await vi.advanceTimersByTimeAsync(3000);
    expect(connections).toEqual(['open', 'second_tab']);
    expect(FakeSocket.all).toHaveLength(1);
  });

  it('takes its own lost line for no other tab', async () => {
    newest().accept();
    newest().fail();
    await vi.advanceTimersByTimeAsync(300);
    newest().accept();
    newest().say({type: 'second_tab', message: 'another tab'});
    await vi.advanceTimersByTimeAsync(2000);
    newest().accept();
    expect(connections.at(-1)).toBe('open');
    expect(connections).not.toContain('second_tab');
  });

  it('stops trying when the trial is not running any more or the person is signed out', async () => {
    newest().accept();
    mine = {status: 200, trialId: null};
    newest().fail();
    await vi.advanceTimersByTimeAsync(10_000);
    expect(connections.at(-1)).toBe('gone');
    expect(FakeSocket.all).toHaveLength(1);
    channel.open();
    mine = {status: 401, trialId: null};
    newest().fail();
    await vi.advanceTimersByTimeAsync(10_000);
    expect(connections.at(-1)).toBe('signed_out');
  });

  it('tells when the trial is filed', () => {
    newest().accept();
    newest().say({type: 'filed', trial_id: 't-1'});
    expect(filed).toEqual(['t-1']);
  });
});
