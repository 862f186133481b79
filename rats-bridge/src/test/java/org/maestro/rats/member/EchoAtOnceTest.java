package org.maestro.rats.member;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A broker may be so quick that a member hears what it says while it still says it. */
class EchoAtOnceTest {

  /** Carries what is published back to its publisher before it returns, and keeps what stands. */
  private static final class Echo implements Transport {
    private final Map<String, MessageHandler> handlers = new LinkedHashMap<>();
    private final Map<String, byte[]> retained = new LinkedHashMap<>();

    @Override
    public String clientId() {
      return "rose";
    }

    @Override
    public void subscribe(String filter, RetainedMessages kept, MessageHandler handler) {
      handlers.put(filter, handler);
    }

    @Override
    public void subscribeToOthers(String filter, MessageHandler handler) {
      handlers.put(filter, handler);
    }

    @Override
    public void askForRetained(String filter) {
      throw new UnsupportedOperationException("no member asks for it");
    }

    @Override
    public void open(Optional<Will> will, ConnectionListener listener) {
      listener.connected();
    }

    @Override
    public void stayAway(Duration pause) {
      throw new UnsupportedOperationException("nobody else has its id");
    }

    @Override
    public void publish(Publication publication, Completion completion) {
      if (publication.payload().length > 0) {
        retained.put(publication.topic(), publication.payload());
      } else {
        retained.remove(publication.topic());
      }
      Optional.ofNullable(handlers.get(publication.topic()))
          .ifPresent(
              handler ->
                  handler.arrived(
                      new Message(
                          publication.topic(), publication.payload(), false, Optional.empty())));
      completion.completed(Optional.empty());
    }

    @Override
    public void leave() {
      handlers.clear();
    }

    @Override
    public void close() {
      handlers.clear();
    }

    @Override
    public void die() {
      handlers.clear();
    }
  }

  @Test
  void whoLeavesDoesNotContradictItself() {
    Echo bus = new Echo();
    MemberProfile profile =
        new MemberProfile("rose", "{}", Set.of("standby"), "standby", Set.of("standby"), Map.of());
    try (PacedClock clock = new PacedClock(1)) {
      RatsMember member = RatsMember.start(profile, List::of, bus, "home", clock);
      assertThat(bus.retained).isNotEmpty();

      member.close();

      assertThat(bus.retained.keySet()).isEmpty();
    }
  }
}
