package org.maestro.rats.protocol;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;

/**
 * A feature call, c = (Id, r, f, p, t) (Three-layered architecture, 3.2.3; M56).
 *
 * @param member r; empty: every member with the feature (Three-layered architecture, 3.2.3; M57)
 * @param boot the member's boot it is meant for; another boot refuses it
 * @param parameters p: JSON values, pointers as {@code {"ref": IRI, property: value}}
 *     (Three-layered architecture, 3.2.3; M58)
 * @param timeout t, covers queueing and execution (Three-layered architecture, 3.2.3; M59)
 * @param from who calls
 * @param task the goal it serves
 * @param expects what the caller counts on; whoever could do it for less may offer to
 *     (Three-layered architecture, 3.2.1; M43)
 * @param sent when the caller made it, by a clock of its own
 */
public record Call(
    String id,
    Optional<String> member,
    Optional<String> boot,
    String feature,
    Map<String, Object> parameters,
    Duration timeout,
    String from,
    Optional<String> task,
    Optional<Expectation> expects,
    Optional<Sent> sent) {

  /** Of which the caller does not say when it was made. */
  public Call(
      String id,
      Optional<String> member,
      Optional<String> boot,
      String feature,
      Map<String, Object> parameters,
      Duration timeout,
      String from,
      Optional<String> task,
      Optional<Expectation> expects) {
    this(id, member, boot, feature, parameters, timeout, from, task, expects, Optional.empty());
  }

  /** Of which the caller does not say what it counts on. */
  public Call(
      String id,
      Optional<String> member,
      Optional<String> boot,
      String feature,
      Map<String, Object> parameters,
      Duration timeout,
      String from,
      Optional<String> task) {
    this(id, member, boot, feature, parameters, timeout, from, task, Optional.empty());
  }

  /** The same call, made then. */
  public Call madeAt(Sent then) {
    return new Call(
        id, member, boot, feature, parameters, timeout, from, task, expects, Optional.of(then));
  }

  /**
   * Whether this is the other one sent again: what its caller counts on, and when it asks, may
   * differ by then.
   */
  public boolean isAgain(Call other) {
    return withoutExpectation().equals(other.withoutExpectation());
  }

  private Call withoutExpectation() {
    return new Call(id, member, boot, feature, parameters, timeout, from, task);
  }

  /**
   * The timestamp that a caller gives its call.
   *
   * @param clock names the clock, which nobody else need share; a caller that cannot rely on its
   *     clock any more names another
   * @param millis of wall time, by that clock, which never goes back
   */
  public record Sent(String clock, long millis) {}

  /**
   * The cost and duration on which a caller counts.
   *
   * @param cost in cost units: seconds plus weighted energy
   * @param seconds simulated seconds from its beginning to its end
   */
  public record Expectation(double cost, double seconds) {}
}
