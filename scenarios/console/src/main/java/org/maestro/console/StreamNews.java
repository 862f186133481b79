package org.maestro.console;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.maestro.console.traffic.StreamedFrames;
import org.maestro.rats.security.Role;
import org.maestro.rats.transport.Message;

/**
 * What members stream, for pages each of which shows one of them. Nothing is kept: a frame goes to
 * who looks now, in the place of one that has not left yet. Any thread may use it.
 */
final class StreamNews implements EventSource {
  private static final String EVENT = "streams";

  private final StreamedFrames frames;
  private final Map<EventQueue, String> shown = new ConcurrentHashMap<>();

  StreamNews(StreamedFrames frames) {
    this.frames = frames;
  }

  /** What goes over the bus; only what somebody looks at is read. */
  void heard(Message message) {
    if (!shown.isEmpty()) {
      frames
          .streamer(message)
          .filter(shown::containsValue)
          .ifPresent(
              member -> frames.document(message).ifPresent(document -> tell(member, document)));
    }
  }

  private void tell(String member, JsonNode document) {
    shown.forEach(
        (listener, wanted) -> {
          if (wanted.equals(member)) {
            listener.addInPlace(EVENT, document);
          }
        });
  }

  /** What rooms look and sound like is for those who may also have it streamed. */
  @Override
  public Role needs() {
    return Role.OPERATOR;
  }

  /** Who names no member hears of none. */
  @Override
  public void listen(EventQueue listener, Runnable then) {
    then.run();
  }

  @Override
  public void leave(EventQueue listener) {
    shown.remove(listener);
  }

  @Override
  public EventSource of(String member) {
    StreamNews all = this;
    return new EventSource() {
      @Override
      public void listen(EventQueue listener, Runnable then) {
        if (!member.isEmpty()) {
          shown.put(listener, member);
        }
        then.run();
      }

      @Override
      public void leave(EventQueue listener) {
        all.leave(listener);
      }
    };
  }
}
