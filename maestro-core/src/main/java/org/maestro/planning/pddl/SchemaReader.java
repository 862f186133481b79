package org.maestro.planning.pddl;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import org.maestro.planning.ground.Amount;
import org.maestro.planning.ground.Atom;
import org.maestro.planning.ground.Comparison;
import org.maestro.planning.ground.Comparison.Relation;
import org.maestro.planning.ground.Literal;
import org.maestro.planning.ground.Schema;
import org.maestro.planning.pddl.Expression.Group;
import org.maestro.planning.pddl.Expression.Word;
import org.maestro.planning.pddl.Symbols.Signature;

/** Reads the parameters, condition and effect of one action, or a goal. */
final class SchemaReader {
  private final Symbols symbols;
  private final String name;
  private final Expression.Position position;
  private final List<BitSet> domains = new ArrayList<>();
  private final Map<String, Integer> scope = new HashMap<>();
  private final List<Literal> conditions = new ArrayList<>();
  private final List<Schema.Sameness> differences = new ArrayList<>();
  private final List<Comparison> comparisons = new ArrayList<>();
  private final List<Atom> additions = new ArrayList<>();
  private final List<Atom> deletions = new ArrayList<>();
  private final List<Schema.Increase> increases = new ArrayList<>();
  private int shown;

  /**
   * @param position where what is read stands
   */
  SchemaReader(Symbols symbols, String name, Expression.Position position) {
    this.symbols = symbols;
    this.name = name;
    this.position = position;
  }

  /** Whatever was read, it never holds. */
  void refuse() {
    differences.add(new Schema.Sameness(0, 0, false));
  }

  Schema done() {
    return new Schema(
        name,
        position.toString(),
        domains,
        shown,
        conditions,
        differences,
        comparisons,
        additions,
        deletions,
        increases);
  }

  void parameters(Group list) {
    addParameters(list.items());
    shown = domains.size();
    if (scope.size() < shown) {
      throw list.position().error("Two parameters have the same name.");
    }
  }

  /** The parameter stands for this object only. */
  void bind(String parameter, Word object) {
    BitSet one = new BitSet();
    one.set(symbols.object(object));
    domains.set(Objects.requireNonNull(scope.get(parameter)), one);
  }

  /** Further variables, which a plan does not show. */
  void addParameters(List<Expression> items) {
    for (Symbols.Typed typed : symbols.readTyped(items, true)) {
      typed.types().forEach(type -> symbols.checkType(typed.name().position(), type));
      scope.put(typed.name().text(), domains.size());
      domains.add(symbols.members(typed.types()));
    }
  }

  /**
   * Checks that a condition of any kind is understood; what is read meanwhile is of no use.
   *
   * @throws PddlException when it is not
   */
  void checkCondition(Expression expression) {
    Group group = expression.group("a condition");
    switch (group.head()) {
      case "and", "or" -> group.rest().forEach(this::checkCondition);
      case "not" -> checkCondition(only(group));
      case "imply" -> {
        if (group.items().size() != 3) {
          throw group.position().error("Expected (imply condition condition).");
        }
        group.rest().forEach(this::checkCondition);
      }
      case "forall", "exists" -> checkQuantified(group, "condition", this::checkCondition);
      case "when", "preference" ->
          throw group
              .position()
              .error("(%s ...) in a condition is not supported.".formatted(group.head()));
      case "" -> {
        if (!group.items().isEmpty()) {
          throw group.position().error("Expected a condition, found a list of lists.");
        }
      }
      default -> condition(group);
    }
  }

  private void checkQuantified(Group group, String kind, Consumer<Expression> check) {
    if (group.items().size() != 3) {
      throw group
          .position()
          .error("Expected (%s (?variable - type ...) %s).".formatted(group.head(), kind));
    }
    Map<String, Integer> outside = Map.copyOf(scope);
    addParameters(group.items().get(1).group("a list of variables").items());
    check.accept(group.items().get(2));
    scope.clear();
    scope.putAll(outside);
  }

  /**
   * Checks that an effect of any kind is understood; what is read meanwhile is of no use.
   *
   * @throws PddlException when it is not
   */
  void checkEffect(Expression expression) {
    Group group = expression.group("an effect");
    switch (group.head()) {
      case "and" -> group.rest().forEach(this::checkEffect);
      case "forall" -> checkQuantified(group, "effect", this::checkEffect);
      case "when" -> {
        if (group.items().size() != 3) {
          throw group.position().error("Expected (when condition effect).");
        }
        checkCondition(group.items().get(1));
        refuseWhen(group.items().get(2));
        checkEffect(group.items().get(2));
      }
      default -> effect(group);
    }
  }

  private static void refuseWhen(Expression expression) {
    if (expression instanceof Group group) {
      if (group.head().equals("when")) {
        throw group.position().error("(when ...) within (when ...) is not supported.");
      }
      group.items().forEach(SchemaReader::refuseWhen);
    }
  }

  /** Reads a plain condition. */
  void condition(Expression expression) {
    Group group = expression.group("a condition");
    switch (group.head()) {
      case "not" -> negated(only(group).group("a condition"));
      case "=" -> relation(group, Relation.EQUAL);
      case "<" -> relation(group, Relation.LESS);
      case "<=" -> relation(group, Relation.AT_MOST);
      case ">" -> relation(group, Relation.MORE);
      case ">=" -> relation(group, Relation.AT_LEAST);
      default -> conditions.add(new Literal(atom(group, symbols.predicates, "predicate"), true));
    }
  }

  private void negated(Group group) {
    if (group.head().equals("=")) {
      sameness(group, false);
    } else {
      conditions.add(new Literal(atom(group, symbols.predicates, "predicate"), false));
    }
  }

  private void relation(Group group, Relation relation) {
    if (group.items().size() != 3) {
      throw group.position().error("Expected two things to compare.");
    }
    if (relation == Relation.EQUAL
        && symbols.isTerm(group.items().get(1))
        && symbols.isTerm(group.items().get(2))) {
      sameness(group, true);
      return;
    }
    comparisons.add(
        new Comparison(relation, amount(group.items().get(1)), amount(group.items().get(2))));
  }

  private void sameness(Group group, boolean same) {
    if (group.items().size() != 3
        || !symbols.isTerm(group.items().get(1))
        || !symbols.isTerm(group.items().get(2))) {
      throw group.position().error("Expected (= term term).");
    }
    differences.add(
        new Schema.Sameness(term(group.items().get(1)), term(group.items().get(2)), same));
  }

  /** Reads a plain effect. */
  void effect(Expression expression) {
    Group group = expression.group("an effect");
    switch (group.head()) {
      case "not" ->
          deletions.add(atom(only(group).group("an atom"), symbols.predicates, "predicate"));
      case "increase" -> increase(group, false);
      case "decrease" -> increase(group, true);
      case "assign", "scale-up", "scale-down", "or", "imply", "exists" ->
          throw group
              .position()
              .error("(%s ...) in an effect is not supported.".formatted(group.head()));
      case "" -> {
        if (!group.items().isEmpty()) {
          throw group.position().error("Expected an effect, found a list of lists.");
        }
      }
      default -> additions.add(atom(group, symbols.predicates, "predicate"));
    }
  }

  private void increase(Group group, boolean less) {
    if (group.items().size() != 3) {
      throw group.position().error("Expected (%s function amount).".formatted(group.head()));
    }
    Expression changed = group.items().get(1);
    Amount amount = amount(group.items().get(2));
    increases.add(
        new Schema.Increase(
            function(changed),
            less
                ? new Amount.Operation('-', new Amount.Constant(BigDecimal.ZERO), amount)
                : amount));
  }

  private Atom function(Expression expression) {
    if (expression instanceof Word word) {
      if (word.isVariable()) {
        throw word.position().error("Expected a function, found %s.".formatted(word.text()));
      }
      return atom(new Group(word.position(), List.of(word)), symbols.functions, "function");
    }
    return atom(expression.group("a function"), symbols.functions, "function");
  }

  private Amount amount(Expression expression) {
    if (expression instanceof Word word && isNumber(word.text())) {
      return new Amount.Constant(new BigDecimal(word.text()));
    }
    if (expression instanceof Group group
        && "+-*/".contains(group.head())
        && group.head().length() == 1) {
      List<Expression> operands = group.rest();
      if (operands.isEmpty()) {
        throw group.position().error("Expected amounts after %s.".formatted(group.head()));
      }
      char operator = group.head().charAt(0);
      if (operands.size() == 1) {
        if (operator != '-') {
          throw group.position().error("Expected two amounts after %s.".formatted(group.head()));
        }
        return new Amount.Operation(
            '-', new Amount.Constant(BigDecimal.ZERO), amount(operands.get(0)));
      }
      Amount result = amount(operands.get(0));
      for (Expression operand : operands.subList(1, operands.size())) {
        result = new Amount.Operation(operator, result, amount(operand));
      }
      return result;
    }
    return new Amount.Value(function(expression));
  }

  static boolean isNumber(String text) {
    return text.matches("[-+]?(\\d+(\\.\\d*)?|\\.\\d+)([e][-+]?\\d{1,3})?");
  }

  private Atom atom(Group group, Map<String, Signature> among, String kind) {
    Word head = group.items().get(0).word("a " + kind + "'s name");
    Signature signature = among.get(head.text());
    if (signature == null) {
      throw head.position().error("There is no %s %s.".formatted(kind, head.text()));
    }
    List<Expression> arguments = group.rest();
    if (arguments.size() != signature.types().size()) {
      throw head.position()
          .error(
              "%s takes %d arguments, found %d."
                  .formatted(head.text(), signature.types().size(), arguments.size()));
    }
    int[] terms = new int[arguments.size()];
    for (int i = 0; i < terms.length; i++) {
      Word argument = arguments.get(i).word("a term");
      terms[i] = term(argument);
      if (!argument.isVariable()) {
        requireType(argument, terms[i], head, signature.types().get(i));
      }
    }
    return new Atom(signature.number(), terms);
  }

  /**
   * What is said of the wrong things matches no step: there would be no plan, and no reason given.
   */
  private void requireType(Word argument, int object, Word head, List<String> types) {
    if (!symbols.isOfType(object, types)) {
      throw argument
          .position()
          .error(
              "%s takes an object of the type %s here, and %s is none."
                  .formatted(head.text(), String.join(" or ", types), argument.text()));
    }
  }

  /** A ground atom, as initial states have them. */
  Atom fact(Group group) {
    return atom(group, symbols.predicates, "predicate");
  }

  /** A ground function, as initial states have them. */
  Atom groundFunction(Expression expression) {
    return function(expression);
  }

  private int term(Expression expression) {
    Word word = expression.word("a term");
    if (!word.isVariable()) {
      return symbols.object(word);
    }
    Integer parameter = scope.get(word.text());
    if (parameter == null) {
      throw word.position().error("There is no parameter %s here.".formatted(word.text()));
    }
    return Atom.parameter(parameter);
  }

  private static Expression only(Group group) {
    if (group.items().size() != 2) {
      throw group.position().error("Expected one thing after %s.".formatted(group.head()));
    }
    return group.items().get(1);
  }
}
