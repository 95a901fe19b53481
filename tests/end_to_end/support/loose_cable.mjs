// A cable between browser and program that a test can pull out: a plain TCP relay.
import net from 'node:net';
import {once} from 'node:events';

export class LooseCable {
  static async plug(port) {
    const cable = new LooseCable();
    cable.plugged = true;
    cable.ends = new Set();
    cable.server = net.createServer((near) => cable.#join(near, port));
    cable.server.listen(0, '127.0.0.1');
    await once(cable.server, 'listening');
    cable.url = `http://127.0.0.1:${cable.server.address().port}`;
    return cable;
  }

  #join(near, port) {
    if (!this.plugged) {
      near.destroy();
      return;
    }
    const far = net.connect(port, '127.0.0.1');
    for (const [end, other] of [[near, far], [far, near]]) {
      this.ends.add(end);
      end.on('error', () => {});
      end.on('close', () => {
        this.ends.delete(end);
        other.destroy();
      });
      end.pipe(other);
    }
  }

  pullOut() {
    this.plugged = false;
    for (const end of this.ends) end.destroy();
  }

  putBack() {
    this.plugged = true;
  }

  async close() {
    this.pullOut();
    this.server.close();
    await once(this.server, 'close');
  }
}
