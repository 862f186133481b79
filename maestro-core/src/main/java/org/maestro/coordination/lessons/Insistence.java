package org.maestro.coordination.lessons;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * A condition that a member insists on, as a refusal of its has shown, beyond the one that it
 * described.
 *
 * @param condition over the feature's parameters and {@code ?self}
 * @param here the same for the step that was refused
 */
public record Insistence(Formula condition, Formula here) {
  private static final Pattern NEED = Pattern.compile("(<=|>=|<|>|=)\\s*(\\S+)");

  /**
   * Reads what a refusal names. The fact has to be one that the feature's own precondition speaks
   * of: how it depends on the step's parameters is described there, and nowhere else.
   *
   * @param known for the limits that the description names
   * @return empty when nothing is insisted on that could be understood, when it is so by the
   *     member's own word, or when no more is insisted on than was described
   */
  static Optional<Insistence> of(
      StepKey step, FeatureType feature, FeatureRun.Learnt ref, Facts known) {
    Optional<Formula.Atom> fact = fact(ref);
    if (ref.need().isEmpty() || fact.isEmpty()) {
      return Optional.empty();
    }
    Map<String, Term> bindings = step.values();
    Substitution substitution = new Substitution(bindings);
    List<Formula> leaves = new ArrayList<>();
    Predicate<Formula.Atom> isMeant = leaf -> substitution.apply(leaf).equals(fact.get());
    Leaves.of(
        feature.precondition(),
        atom -> {
          if (isMeant.test(atom)) {
            truth(ref).map(wanted -> wanted ? atom : new Formula.Not(atom)).ifPresent(leaves::add);
          }
        },
        fluent -> {
          if (isMeant.test(new Formula.Atom(fluent.name(), fluent.arguments()))) {
            comparison(fluent, ref).ifPresent(leaves::add);
          }
        });
    return leaves.stream()
        .filter(leaf -> !isDescribed(leaf, feature.precondition(), bindings, known))
        .findFirst()
        .map(
            leaf ->
                new Insistence(tolerant(leaf, feature.precondition()), substitution.apply(leaf)));
  }

  /** Where the description lets an unknown number pass, so does what is learnt of it. */
  private static Formula tolerant(Formula leaf, Formula described) {
    if (leaf instanceof Formula.Comparison comparison
        && comparison.left() instanceof Expression.Fluent fluent
        && passesUnknown(described, new Formula.UnknownNumber(fluent))) {
      return new Formula.Or(List.of(new Formula.UnknownNumber(fluent), leaf));
    }
    return leaf;
  }

  private static boolean passesUnknown(Formula described, Formula.UnknownNumber unknown) {
    if (described instanceof Formula.And and) {
      return and.operands().stream().anyMatch(part -> passesUnknown(part, unknown));
    }
    return described instanceof Formula.Or or && or.operands().contains(unknown);
  }

  /** The facts that a failure speaks of; fluents are written as atoms. */
  public static Set<Formula.Atom> facts(List<FeatureRun.Learnt> refs) {
    Set<Formula.Atom> facts = new LinkedHashSet<>();
    refs.forEach(ref -> fact(ref).ifPresent(facts::add));
    return facts;
  }

  /** Whether the other says the same with another limit. */
  boolean isRenewedBy(Insistence other) {
    return demand() instanceof Formula.Comparison mine
            && other.demand() instanceof Formula.Comparison its
        ? mine.relation() == its.relation() && mine.left().equals(its.left())
        : condition.equals(other.condition);
  }

  /** The condition for what is known. */
  private Formula demand() {
    return condition instanceof Formula.Or or
        ? or.operands().get(or.operands().size() - 1)
        : condition;
  }

  private static Optional<Formula.Atom> fact(FeatureRun.Learnt ref) {
    try {
      return SlParser.fact(ref.fact()) instanceof Fact.Holds holds
          ? Optional.of(holds.atom())
          : Optional.empty();
    } catch (SlSyntaxException e) {
      return Optional.empty();
    }
  }

  private static Optional<Boolean> truth(FeatureRun.Learnt ref) {
    String need = ref.need().orElse("").strip();
    return need.equals("true") || need.equals("false")
        ? Optional.of(need.equals("true"))
            .filter(wanted -> !new Term.Truth(wanted).equals(ref.value()))
        : Optional.empty();
  }

  private static Optional<Formula> comparison(Expression.Fluent fluent, FeatureRun.Learnt ref) {
    Matcher matcher = NEED.matcher(ref.need().orElse("").strip());
    if (!matcher.matches() || !(ref.value() instanceof Term.Number have)) {
      return Optional.empty();
    }
    for (Formula.Relation relation : Formula.Relation.values()) {
      if (relation.symbol().equals(matcher.group(1))) {
        return limit(matcher.group(2))
            .filter(limit -> !holds(relation, have.value(), limit))
            .map(
                limit ->
                    new Formula.Comparison(
                        relation, fluent, new Expression.OfTerm(new Term.Number(limit))));
      }
    }
    return Optional.empty();
  }

  /** Whether the description asks for it already, by the same words or by a limit as strict. */
  private static boolean isDescribed(
      Formula leaf, Formula described, Map<String, Term> bindings, Facts known) {
    if (described instanceof Formula.And and) {
      return and.operands().stream().anyMatch(part -> isDescribed(leaf, part, bindings, known));
    }
    if (described instanceof Formula.Or or) {
      List<Formula> ofWhatIsKnown =
          or.operands().stream().filter(part -> !(part instanceof Formula.UnknownNumber)).toList();
      return ofWhatIsKnown.size() == 1 && isDescribed(leaf, ofWhatIsKnown.get(0), bindings, known);
    }
    if (!(leaf instanceof Formula.Comparison wanted)
        || !(described instanceof Formula.Comparison stated)
        || !wanted.left().equals(stated.left())) {
      return leaf.equals(described);
    }
    Evaluation evaluation = new Evaluation(known);
    OptionalDouble limit = evaluation.number(wanted.right(), bindings);
    OptionalDouble least = evaluation.number(stated.right(), bindings);
    return limit.isPresent()
        && least.isPresent()
        && (isUpwards(stated) && isUpwards(wanted)
            ? least.getAsDouble() >= limit.getAsDouble()
            : isDownwards(stated)
                && isDownwards(wanted)
                && least.getAsDouble() <= limit.getAsDouble());
  }

  private static boolean isUpwards(Formula.Comparison comparison) {
    return comparison.relation() == Formula.Relation.AT_LEAST
        || comparison.relation() == Formula.Relation.GREATER;
  }

  private static boolean isDownwards(Formula.Comparison comparison) {
    return comparison.relation() == Formula.Relation.AT_MOST
        || comparison.relation() == Formula.Relation.LESS;
  }

  private static boolean holds(Formula.Relation relation, double value, double limit) {
    return switch (relation) {
      case EQUAL -> value == limit;
      case LESS -> value < limit;
      case AT_MOST -> value <= limit;
      case GREATER -> value > limit;
      case AT_LEAST -> value >= limit;
    };
  }

  private static Optional<Double> limit(String text) {
    try {
      return Optional.of(Double.valueOf(text)).filter(Double::isFinite);
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }
}
