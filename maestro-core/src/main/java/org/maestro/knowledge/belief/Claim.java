package org.maestro.knowledge.belief;

import org.maestro.knowledge.api.Source;
import org.maestro.sl.Term;

/**
 * A statement of one source about a state variable.
 *
 * @param has whether the variable has the value, or is known not to have it
 */
public record Claim(Held held, boolean has) {

  /**
   * How much it counts against claims of other sources. Whatever was seen or stated counts more
   * than what is merely expected; a number that is reckoned forward from a measured one counts as
   * much as its confidence says.
   */
  double weight() {
    return held.isExpected() && !held.isNumber() ? 0 : held.confidence();
  }

  Term value() {
    return held.value();
  }

  boolean isOf(String agent) {
    return held.source().agent().equals(agent);
  }

  /** Both cannot be so. */
  boolean contradicts(Claim other) {
    boolean same = value().equals(other.value());
    return has && other.has ? !same : has != other.has && same;
  }

  /**
   * Whether the other, older one need not be kept: within a source the newer counts, across sources
   * the surer, and of equally sure ones the newer. What a step brings about is no opinion on what
   * was before it, and outdates it all. What another saw is kept beside a member's own word to the
   * same effect: it is the better witness.
   */
  boolean outdates(Claim other) {
    if (isOwnWordFor(other)) {
      return false;
    }
    boolean speaksOfIt = has || other.value().equals(value());
    boolean mayOverrule =
        isOf(other.held.source().agent())
            || held.isExpected()
            || held.source().kind() == Source.Kind.STATED && other.held.isExpected()
            || weight() >= other.weight();
    return speaksOfIt && mayOverrule;
  }

  private boolean isOwnWordFor(Claim other) {
    return held.source().kind() == Source.Kind.STATED
        && other.held.source().kind() == Source.Kind.OBSERVED
        && !isOf(other.held.source().agent())
        && has == other.has
        && value().equals(other.value());
  }

  /**
   * Whether that is a matter of two sources that do not agree. Who states something tells when it
   * changes: what somebody else's step is expected to have made of it does not silence that.
   */
  boolean overrules(Claim other) {
    return (!held.isExpected() || other.held.source().kind() == Source.Kind.STATED)
        && !isOf(other.held.source().agent())
        && contradicts(other);
  }
}
