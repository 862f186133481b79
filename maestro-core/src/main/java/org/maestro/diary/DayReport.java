package org.maestro.diary;

import java.time.Instant;
import java.time.LocalDate;
import java.util.List;
import java.util.Optional;

/**
 * A person's day, as it is known (ADE, 5; A70). Times are those of the home's clock.
 *
 * @param person by her name in the home
 * @param until when it ends: at midnight, or now
 * @param silences in which nobody knew where she was, a minute and longer
 * @param changes of what devices are at, oldest first
 * @param requests of anybody, oldest first
 * @param leftOut how much more there is that who asks may not read
 */
public record DayReport(
    String person,
    LocalDate date,
    Instant until,
    List<Stay> stays,
    List<Silence> silences,
    List<Change> changes,
    List<Request> requests,
    int leftOut) {
  public DayReport {
    stays = List.copyOf(stays);
    silences = List.copyOf(silences);
    changes = List.copyOf(changes);
    requests = List.copyOf(requests);
  }

  /**
   * She was known to be in a zone.
   *
   * @param fact that says so
   */
  public record Stay(String zone, String fact, Instant from, Instant to) {}

  /** Nobody knew where she was. */
  public record Silence(Instant from, Instant to) {}

  /**
   * A device is at something else from then on.
   *
   * @param fact in MAESTRO-SL
   */
  public record Change(Instant at, String fact) {}

  /**
   * Somebody has asked for something.
   *
   * @param goal in MAESTRO-SL
   * @param by the agent that asked, and its user
   * @param person for whom, where that is known
   * @param end how it ended; empty: it had not by the end of the day
   */
  public record Request(
      Instant at, String id, String goal, String by, Optional<String> person, Optional<End> end) {}

  /**
   * The end of what was asked for.
   *
   * @param how {@code reached}, {@code unseen}, {@code failed} or {@code cancelled}
   * @param reason "" where it was reached
   */
  public record End(Instant at, String how, String reason) {}
}
