package org.maestro.rats.member;

import java.util.ArrayDeque;
import java.util.Deque;
import org.maestro.rats.protocol.StreamFrame;

/**
 * The frames of one call on their way to the bus: one is under way at a time, and of those that
 * wait for it the newest are kept. Live pictures are worth nothing late, so that of them one is
 * kept; of sound, where each stretch that is missing is heard, two seconds of the usual tenths. Any
 * thread.
 */
final class StreamOutlet {

  private static final String PICTURES = "image/";
  private static final int MOST_PICTURES = 1;
  private static final int MOST_OTHERS = 20;

  /** Hands a frame to the bus. */
  interface Sender {
    /**
     * @param over is run once, on any thread, when the frame has left or cannot
     */
    void send(StreamFrame frame, Runnable over);
  }

  private final Sender sender;
  private final Deque<StreamFrame> waiting = new ArrayDeque<>();
  private boolean isUnderWay;

  StreamOutlet(Sender sender) {
    this.sender = sender;
  }

  void add(StreamFrame frame) {
    synchronized (this) {
      waiting.addLast(frame);
      if (isUnderWay) {
        int most = frame.mediaType().startsWith(PICTURES) ? MOST_PICTURES : MOST_OTHERS;
        if (waiting.size() > most) {
          waiting.removeFirst();
        }
        return;
      }
      isUnderWay = true;
    }
    sendNext();
  }

  /** Nothing leaves any more but what is under way. */
  synchronized void end() {
    waiting.clear();
  }

  private void sendNext() {
    StreamFrame next;
    synchronized (this) {
      if (waiting.isEmpty()) {
        isUnderWay = false;
        return;
      }
      next = waiting.removeFirst();
    }
    sender.send(next, this::sendNext);
  }
}
