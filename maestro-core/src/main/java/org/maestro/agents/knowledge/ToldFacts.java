package org.maestro.agents.knowledge;

import java.util.List;
import java.util.Optional;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.StatementCheck;
import org.maestro.rats.protocol.Complaints;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Those facts of what a member tells that can be so: their words are there, and the things that
 * they name are of the classes that the words are for. The others cost one line of log now and
 * then. The knowledge agent's thread only.
 */
public final class ToldFacts {
  private static final Logger LOG = LoggerFactory.getLogger(ToldFacts.class);

  private final Complaints complaints = new Complaints();

  /** Things that the home does not know yet may be of any class. */
  public List<String> possible(String member, List<String> facts, Home home) {
    StatementCheck check = new StatementCheck(home, "it");
    return facts.stream().filter(fact -> isPossible(member, fact, check)).toList();
  }

  private boolean isPossible(String member, String text, StatementCheck check) {
    Optional<String> fault = fault(text, check);
    if (fault.isPresent() && complaints.isDue(member)) {
      LOG.warn(
          "{} says '{}', which cannot be and is passed over: {}",
          member,
          Complaints.shortened(text),
          Complaints.shortened(fault.get()));
    }
    return fault.isEmpty();
  }

  /** What is no fact at all is refused by who reads it. */
  private static Optional<String> fault(String text, StatementCheck check) {
    try {
      return check.misfit(SlParser.fact(text));
    } catch (SlSyntaxException noFact) {
      return Optional.empty();
    }
  }
}
