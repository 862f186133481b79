package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The worth of a goal at one moment, and the numbers that it comes from (ADE, 4.1; A52 to A54):
 * {@code u = p·b − c}, {@code g = (te/ta)·(gmax − gmin) + gmin}, {@code priority = u·g}.
 *
 * @param chance p, learned from goals of the same shape
 * @param tried how many of these it was learned from
 * @param benefit b, in the unit of costs; empty while it is not known
 * @param cost c, of what is left of the plan
 * @param elapsed te, since the goal is pursued
 * @param allowed ta; empty: it has all the time there is, and g stays at gmin
 * @param urgencyFrom gmin
 * @param urgencyTo gmax
 */
public record Worth(
    double chance,
    int tried,
    OptionalDouble benefit,
    double cost,
    Duration elapsed,
    Optional<Duration> allowed,
    double urgencyFrom,
    double urgencyTo) {

  /** u; empty while the benefit is not known. */
  public OptionalDouble utility() {
    return benefit.isPresent()
        ? OptionalDouble.of(chance * benefit.getAsDouble() - cost)
        : OptionalDouble.empty();
  }

  /** g, which stays at its upper bound once the time is over. */
  public double urgency() {
    return timeUsed() * (urgencyTo - urgencyFrom) + urgencyFrom;
  }

  /** The share of its time that is over, 0 to 1; 0 where it has all the time there is. */
  public double timeUsed() {
    if (allowed.isEmpty()) {
      return 0;
    }
    double total = allowed.get().toNanos();
    return total <= 0 ? 1 : Math.max(0, Math.min(1, elapsed.toNanos() / total));
  }

  /** u·g; empty while the benefit is not known. */
  public OptionalDouble priority() {
    OptionalDouble utility = utility();
    return utility.isPresent()
        ? OptionalDouble.of(utility.getAsDouble() * urgency())
        : OptionalDouble.empty();
  }

  /** Whether it is to be begun; one whose benefit is not known is, as any goal without one. */
  public boolean isWorthIt() {
    return utility().isEmpty() || utility().getAsDouble() > 0;
  }

  /** See {@link GoalPriority#grade}. */
  public int grade() {
    return isWorthIt()
        ? priority().isPresent()
            ? GoalPriority.grade(priority().getAsDouble())
            : GoalPriority.UNWEIGHED
        : GoalPriority.WORTHLESS;
  }

  /**
   * After how much time of pursuit the goal is in another grade, if nothing but time changes; empty
   * when it never is.
   */
  public Optional<Duration> nextGradeAt() {
    double growth = urgencyTo - urgencyFrom;
    if (allowed.isEmpty()
        || growth <= 0
        || utility().isEmpty()
        || !isWorthIt()
        || elapsed.compareTo(allowed.get()) >= 0
        || GoalPriority.grade(utility().getAsDouble() * urgencyTo) <= grade()) {
      return Optional.empty();
    }
    double wanted = GoalPriority.lowestOf(grade() + 1) / utility().getAsDouble();
    double share = Math.min(1, (wanted - urgencyFrom) / growth);
    long nanos = (long) Math.ceil(share * allowed.get().toNanos());
    Duration at = Duration.ofMillis(nanos / 1_000_000 + 1);
    return Optional.of(at.compareTo(elapsed) > 0 ? at : elapsed.plusMillis(1));
  }

  /** Why it is not begun: what it brings against what it costs. */
  public String deficitInWords() {
    return "not worth it: %s against %s"
        .formatted(number(chance * benefit.orElse(0)), number(cost));
  }

  /** The formulas with the numbers in them, for people. */
  public String inWords() {
    if (benefit.isEmpty()) {
      return "its benefit is not known, so it counts as a goal without one";
    }
    return "u = %s·%s − %s = %s; g = %s; priority u·g = %s"
        .formatted(
            number(chance),
            number(benefit.getAsDouble()),
            number(cost),
            number(utility().orElseThrow()),
            urgencyInWords(),
            number(priority().orElseThrow()));
  }

  private String urgencyInWords() {
    return allowed
        .map(
            total ->
                "(%s s / %s s)·(%s − %s) + %s = %s"
                    .formatted(
                        number(Math.min(seconds(elapsed), seconds(total))),
                        number(seconds(total)),
                        number(urgencyTo),
                        number(urgencyFrom),
                        number(urgencyFrom),
                        number(urgency())))
        .orElse(number(urgencyFrom));
  }

  private static double seconds(Duration time) {
    return time.toNanos() / 1e9;
  }

  private static String number(double value) {
    return Sentences.number(value);
  }
}
