package org.maestro.knowledge;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.StatementCheck;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.NumberVariables;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Understands what is asked in a home, or says why it cannot be answered: a question is refused
 * where a goal of the same words is. Immutable.
 */
public final class QuestionReader {
  private static final String VALUE = "value";

  private final Home home;
  private final StatementCheck statements;

  public QuestionReader(Home home) {
    this.home = home;
    this.statements = new StatementCheck(home, "The question");
  }

  /**
   * The question as the vocabulary understands it: a number alone asks for its value.
   *
   * @throws KnowledgeException when it speaks of what nobody knows, or has no end
   */
  public Formula question(Formula asked) {
    if (asked instanceof Formula.Keep) {
      throw new KnowledgeException(
          "The question has keep around it, which goals have; ask for what is inside.");
    }
    if (asked instanceof Formula.Bound) {
      throw new KnowledgeException(
          "The question is bound to a time or an event, as goals are; ask for what is inside.");
    }
    Formula question =
        asked instanceof Formula.Atom atom && home.vocabulary().isFluent(atom.predicate())
            ? new Formula.Comparison(
                Formula.Relation.EQUAL,
                new Expression.Fluent(atom.predicate(), atom.arguments()),
                new Expression.OfTerm(new Term.Variable(unused(atom))))
            : SlParser.formula(SlPrinter.print(asked), home.vocabulary()::isFluent);
    refuse(statements.fault(question));
    refuse(endless(question));
    return question;
  }

  /**
   * A statement whose past is asked for.
   *
   * @throws KnowledgeException when it speaks of what nobody knows
   */
  public String fact(String asked) {
    Fact fact = SlParser.fact(asked);
    refuse(statements.fault(fact));
    return asked;
  }

  /** A name that the atom does not use. */
  private static String unused(Formula.Atom atom) {
    String name = VALUE;
    while (atom.arguments().contains(new Term.Variable(name))) {
      name += "-";
    }
    return name;
  }

  /** There are only so many individuals, but numbers without end. */
  private static Optional<String> endless(Formula question) {
    Set<String> free = FreeVariables.of(question);
    Map<String, List<Expression>> equations = NumberVariables.equationsIn(question);
    return NumberVariables.of(question).stream()
        .filter(variable -> !free.contains(variable) || !equations.containsKey(variable))
        .findFirst()
        .map(
            variable ->
                "The question does not say which number ?%1$s is; ask (= (f x) ?%1$s) for that of (f x)."
                    .formatted(variable));
  }

  private static void refuse(Optional<String> fault) {
    fault.ifPresent(
        sentence -> {
          throw new KnowledgeException(sentence);
        });
  }
}
