// Keeps the drawing from taking the machine: no picture is begun before the last one is finished,
// and where the processor draws, as long as a picture took is left to everything else.
export interface Finish {
  isReached(): boolean;
  forget(): void;
}

const longestWait_ms = 250;  // a finish that is never reported must not stop the picture

export class DrawPacer {
  private finish: Finish | null = null;
  private begun_ms = 0;
  private restUntil_ms = -Infinity;

  constructor(private readonly restsAfterwards: boolean) {}

  mayDraw(now_ms: number): boolean {
    if (this.finish && (this.finish.isReached() || now_ms - this.begun_ms > longestWait_ms)) {
      this.finish.forget();
      this.finish = null;
      if (this.restsAfterwards) this.restUntil_ms = now_ms + Math.min(longestWait_ms, now_ms - this.begun_ms);
    }
    return this.finish === null && now_ms >= this.restUntil_ms;
  }

  drawn(now_ms: number, finish: Finish | null): void {
    this.begun_ms = now_ms;
    this.finish = finish;
  }
}

/** The moment when the GPU, or what stands in for it, has done everything asked of it so far. */
export function finishOf(context: WebGL2RenderingContext): Finish | null {
  const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!fence) return null;
  context.flush();
  return {
    isReached: () => context.getSyncParameter(fence, context.SYNC_STATUS) === context.SIGNALED,
    forget: () => context.deleteSync(fence),
  };
}
