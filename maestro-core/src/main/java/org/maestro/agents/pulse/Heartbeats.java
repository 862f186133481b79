package org.maestro.agents.pulse;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * A failure detector: who of several is alive, by their last signs of life. Times are wall time
 * since some start. Any thread may call.
 *
 * <p>When the signs of life of half of them or more come late, what they share is slow: the
 * network, or who listens. Then all have more time, within bounds; that all fall silent at once
 * gives them none.
 */
final class Heartbeats {
  private static final double USUAL_PERIODS = 1.5;
  private static final double MOST_PATIENT = 8;
  private static final double FADES = 0.9;

  private final HeartbeatSettings settings;
  private final String own;
  private final SortedMap<String, Heard> heardByName = new TreeMap<>();
  private Duration lastCheck;
  private double patience = 1;

  /** Somebody's condition has changed. */
  record Change(String name, Condition now, Duration silence) {}

  /**
   * @param pauseNanos the longest between two of its last signs of life; those of long ago count
   *     less
   * @param mayBeSilent as was promised: so long it is not given up
   */
  private record Heard(Duration at, Condition condition, double pauseNanos, Duration mayBeSilent) {
    private Heard later(Duration by) {
      return new Heard(at.plus(by), condition, pauseNanos, mayBeSilent);
    }

    private Heard now(Condition changed) {
      return new Heard(at, changed, pauseNanos, mayBeSilent);
    }
  }

  /**
   * @param own who listens, under the name by which it gives signs of life itself
   * @param now the time at which it begins
   */
  Heartbeats(HeartbeatSettings settings, String own, Duration now) {
    this.settings = settings;
    this.own = own;
    this.lastCheck = now;
  }

  /**
   * A sign of life; from one not known yet it is the first. Of one that is lost it says nothing.
   */
  synchronized void heard(String name, Duration at) {
    if (name.equals(own)) {
      // Others have been heard as late as it has heard itself.
      excuse(at.minus(judgedAt(at)));
    }
    heardByName.merge(
        name,
        new Heard(at, Condition.ALIVE, 0, lostAfter()),
        (before, first) ->
            before.condition() == Condition.LOST
                ? before
                : new Heard(
                    at,
                    before.condition(),
                    Math.max((double) at.minus(before.at()).toNanos(), FADES * before.pauseNanos()),
                    lostAfter()));
  }

  /** By how much its last signs of life came late, at the worst. */
  synchronized Duration lateness(String name) {
    double nanos = heardByName.containsKey(name) ? heardByName.get(name).pauseNanos() : 0;
    Duration late = Duration.ofNanos(Math.round(nanos)).minus(settings.period().multipliedBy(2));
    return late.isNegative() ? Duration.ZERO : late;
  }

  /** Who is silent now is suspected after this. */
  synchronized Duration suspectedAfter() {
    return times(settings.suspectedAfter());
  }

  /** Who gives a sign of life now is given up after this at the earliest. */
  synchronized Duration lostAfter() {
    return times(settings.lostAfter());
  }

  /** An agent of a living process is replaced when it has done nothing for so long. */
  synchronized Duration hungAfter() {
    return times(settings.hungAfter());
  }

  private Duration times(Duration usual) {
    return Duration.ofNanos(Math.round(usual.toNanos() * patience));
  }

  private double patienceNow() {
    double[] pauses =
        heardByName.values().stream()
            .filter(heard -> heard.condition() != Condition.LOST)
            .mapToDouble(Heard::pauseNanos)
            .sorted()
            .toArray();
    double median = pauses.length == 0 ? 0 : pauses[(pauses.length - 1) / 2];
    double periods = median / settings.period().toNanos();
    return Math.min(MOST_PATIENT, Math.max(1, periods / USUAL_PERIODS));
  }

  /** Nobody waits for signs of life of this name any more. */
  synchronized void forget(String name) {
    heardByName.remove(name);
  }

  /** What has changed since the last check, in the order of the names. To be called each period. */
  synchronized List<Change> check(Duration now) {
    Duration late = now.minus(lastCheck).minus(settings.period());
    lastCheck = now;
    if (late.compareTo(settings.period()) > 0) {
      // Who has slept itself has heard nobody meanwhile, and cannot say that they were silent.
      excuse(late);
    }
    patience = patienceNow();
    Duration judged = judgedAt(now);
    List<Change> changes = new ArrayList<>();
    heardByName.replaceAll(
        (name, heard) -> {
          Duration silence = judged.minus(heard.at());
          Condition condition = condition(heard, silence);
          if (condition != heard.condition()) {
            changes.add(new Change(name, condition, silence));
          }
          return heard.now(condition);
        });
    return changes;
  }

  private void excuse(Duration lateness) {
    if (!lateness.isZero()) {
      heardByName.replaceAll((name, heard) -> heard.later(lateness));
    }
  }

  /** Who does not even hear itself in time is short of it, and hears others late too. */
  private Duration judgedAt(Duration now) {
    Heard itself = heardByName.get(own);
    if (itself == null) {
      return now;
    }
    Duration latest = itself.at().plus(settings.period().multipliedBy(2));
    return now.compareTo(latest) < 0 ? now : latest;
  }

  private Condition condition(Heard heard, Duration silence) {
    boolean isGivenUp =
        silence.compareTo(lostAfter()) >= 0 && silence.compareTo(heard.mayBeSilent()) >= 0;
    if (heard.condition() == Condition.LOST || isGivenUp) {
      return Condition.LOST;
    }
    return silence.compareTo(suspectedAfter()) >= 0 ? Condition.SUSPECTED : Condition.ALIVE;
  }

  synchronized SortedMap<String, Condition> conditions() {
    SortedMap<String, Condition> conditions = new TreeMap<>();
    heardByName.forEach((name, heard) -> conditions.put(name, heard.condition()));
    return conditions;
  }

  /** The last sign of life of each. */
  synchronized SortedMap<String, LifeSign> signs(Duration now) {
    SortedMap<String, LifeSign> signs = new TreeMap<>();
    heardByName.forEach(
        (name, heard) -> signs.put(name, new LifeSign(heard.condition(), now.minus(heard.at()))));
    return signs;
  }

  /** The timing that holds now. */
  synchronized HeartbeatSettings timing() {
    return new HeartbeatSettings(settings.period(), suspectedAfter(), lostAfter());
  }
}
