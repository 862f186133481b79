package org.maestro.agents.pulse;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Who of several is alive, by their last signs of life. Times are wall time since some start. Any
 * thread may call.
 */
final class Heartbeats {
  private final HeartbeatSettings settings;
  private final SortedMap<String, Heard> heardByName = new TreeMap<>();
  private Duration lastCheck;

  /** Somebody's condition has changed. */
  record Change(String name, Condition now, Duration silence) {}

  private record Heard(Duration at, Condition condition) {}

  /**
   * @param now the time at which it begins
   */
  Heartbeats(HeartbeatSettings settings, Duration now) {
    this.settings = settings;
    this.lastCheck = now;
  }

  /**
   * A sign of life; from one not known yet it is the first. Of one that is lost it says nothing.
   */
  synchronized void heard(String name, Duration at) {
    Heard before = heardByName.get(name);
    if (before == null) {
      heardByName.put(name, new Heard(at, Condition.ALIVE));
    } else if (before.condition() != Condition.LOST) {
      heardByName.put(name, new Heard(at, before.condition()));
    }
  }

  /** Nobody waits for signs of life of this name any more. */
  synchronized void forget(String name) {
    heardByName.remove(name);
  }

  /** What has changed since the last check, in the order of the names. To be called each period. */
  synchronized List<Change> check(Duration now) {
    Duration own = now.minus(lastCheck).minus(settings.period());
    lastCheck = now;
    if (own.compareTo(settings.period()) > 0) {
      // Who has slept itself has heard nobody meanwhile, and cannot say that they were silent.
      heardByName.replaceAll((name, heard) -> new Heard(heard.at().plus(own), heard.condition()));
    }
    List<Change> changes = new ArrayList<>();
    heardByName.replaceAll(
        (name, heard) -> {
          Duration silence = now.minus(heard.at());
          Condition condition = condition(heard.condition(), silence);
          if (condition != heard.condition()) {
            changes.add(new Change(name, condition, silence));
          }
          return new Heard(heard.at(), condition);
        });
    return changes;
  }

  private Condition condition(Condition before, Duration silence) {
    if (before == Condition.LOST || silence.compareTo(settings.lostAfter()) >= 0) {
      return Condition.LOST;
    }
    return silence.compareTo(settings.suspectedAfter()) >= 0
        ? Condition.SUSPECTED
        : Condition.ALIVE;
  }

  synchronized SortedMap<String, Condition> conditions() {
    SortedMap<String, Condition> conditions = new TreeMap<>();
    heardByName.forEach((name, heard) -> conditions.put(name, heard.condition()));
    return conditions;
  }
}
