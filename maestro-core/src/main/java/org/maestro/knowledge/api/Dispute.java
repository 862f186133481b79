package org.maestro.knowledge.api;

import java.util.List;
import java.util.Optional;

/**
 * Sources that do not agree on something, and how that was settled (Three-layered architecture, 2;
 * M10).
 *
 * @param believed empty when what was believed is withdrawn, and the others were overruled before
 * @param losers the latest first
 */
public record Dispute(Optional<Belief> believed, List<Loser> losers) {
  public Dispute {
    losers = List.copyOf(losers);
  }

  /** A statement that is not believed, and by which rule. */
  public record Loser(Belief belief, Rule rule) {}

  /** The rule by which a disagreement of sources is settled. Within one source the newer counts. */
  public enum Rule {
    SURER("the surer source counts"),
    LATER("of equally sure sources, what was received later counts"),
    SEEN("what was seen or stated counts more than what was expected");

    private final String sentence;

    Rule(String sentence) {
      this.sentence = sentence;
    }

    public String sentence() {
      return sentence;
    }
  }
}
