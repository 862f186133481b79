package org.maestro.chaos;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Disturbance;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;

/**
 * All that disturbs one bus at the same time, one after the other. However late a retained message
 * is, no later one of its topic overtakes it: no broker does that. In the clock's turn only.
 */
final class Disturbances implements Disturbance {
  private final List<Disturbance> active = new ArrayList<>();
  private final Map<String, Duration> latestOfTopic = new HashMap<>();
  private final Clock clock;

  Disturbances(Clock clock) {
    this.clock = clock;
  }

  /** Begins one more, which ends by itself. */
  void add(InProcessBus bus, Disturbance more, Duration lasts) {
    active.add(more);
    bus.disturb(this);
    clock.schedule(lasts, "chaos", () -> active.remove(more));
  }

  @Override
  public List<Copy> published(String client, Publication publication) {
    List<Copy> copies = List.of(new Copy(publication, Duration.ZERO));
    for (Disturbance disturbance : active) {
      List<Copy> next = new ArrayList<>();
      for (Copy copy : copies) {
        disturbance
            .published(client, copy.publication())
            .forEach(
                made -> next.add(new Copy(made.publication(), copy.later().plus(made.later()))));
      }
      copies = next;
    }
    return copies.stream().map(this::inOrder).toList();
  }

  private Copy inOrder(Copy copy) {
    if (!copy.publication().retained()) {
      return copy;
    }
    Duration now = clock.now();
    Duration at =
        latestOfTopic.merge(
            copy.publication().topic(),
            now.plus(copy.later()),
            (latest, wanted) -> latest.compareTo(wanted) > 0 ? latest : wanted);
    return new Copy(copy.publication(), at.minus(now));
  }

  @Override
  public Duration heardLater(String client) {
    return active.stream()
        .map(disturbance -> disturbance.heardLater(client))
        .max(Duration::compareTo)
        .orElse(Duration.ZERO);
  }
}
