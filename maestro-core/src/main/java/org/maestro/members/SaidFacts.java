package org.maestro.members;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.rats.protocol.Complaints;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Those facts of what a member says that can be read. The others cost one line of log now and then,
 * and nothing else: what stands beside them counts. Safe for use by several threads.
 */
final class SaidFacts {
  private static final Logger LOG = LoggerFactory.getLogger(SaidFacts.class);

  private final Complaints complaints = new Complaints();

  /** Of what it says of itself. */
  List<String> readable(String member, List<String> facts) {
    return facts.stream().filter(fact -> isReadable(member, fact)).toList();
  }

  /** Of the reasons for a failure. */
  List<FeatureRun.Learnt> readableReasons(String member, List<FeatureRun.Learnt> reasons) {
    return reasons.stream().filter(reason -> isReadable(member, reason.fact())).toList();
  }

  private boolean isReadable(String member, String text) {
    Optional<String> fault = fault(text);
    if (fault.isPresent() && complaints.isDue(member)) {
      LOG.warn(
          "{} says '{}', which is no fact and is passed over: {}",
          member,
          Complaints.shortened(text),
          Complaints.shortened(fault.get()));
    }
    return fault.isEmpty();
  }

  private static Optional<String> fault(String text) {
    Fact fact;
    try {
      fact = SlParser.fact(text);
    } catch (SlSyntaxException noFact) {
      return Optional.of(Objects.requireNonNullElse(noFact.getMessage(), noFact.toString()));
    }
    if (!isGround(fact)) {
      return Optional.of("It has variables; it must name the things in it.");
    }
    boolean isNumber =
        !(fact instanceof Fact.Equation equation)
            || !(equation.value() instanceof Term.Number number)
            || Double.isFinite(number.value());
    return isNumber ? Optional.empty() : Optional.of("Its value is not a finite number.");
  }

  private static boolean isGround(Fact fact) {
    if (fact instanceof Fact.Equation equation) {
      Expression.Fluent fluent = equation.fluent();
      return new Formula.Atom(fluent.name(), fluent.arguments()).isGround()
          && !(equation.value() instanceof Term.Variable);
    }
    Formula.Atom atom =
        fact instanceof Fact.Holds holds
            ? holds.atom()
            : fact instanceof Fact.Excluded excluded
                ? excluded.atom()
                : ((Fact.Unknown) fact).atom();
    return atom.isGround();
  }
}
