package org.maestro.planning.pddl;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.planning.pddl.Expression.Group;
import org.maestro.planning.pddl.Expression.Word;

/**
 * Conditions with {@code or}, {@code imply}, {@code forall}, {@code exists} and {@code not} around
 * any of them, as alternatives of plain ones: what is said of all objects is said of each, and what
 * no action changes is decided at once. Its conditions were understood before.
 */
final class Alternatives {
  private final Symbols symbols;
  private final InitialFacts facts;
  private final int most;
  private int variables;
  private boolean exceeded;

  /**
   * Plain conditions that have to hold together for some objects.
   *
   * @param literals by their text
   * @param variables that stand for the objects, with their types
   */
  record Alternative(Map<String, Expression> literals, List<Expression> variables) {
    static final Alternative ALWAYS = new Alternative(Map.of(), List.of());

    Alternative and(Alternative other) {
      Map<String, Expression> all = new LinkedHashMap<>(literals);
      all.putAll(other.literals);
      List<Expression> both = new ArrayList<>(variables);
      both.addAll(other.variables);
      return new Alternative(all, both);
    }
  }

  /**
   * @param most alternatives that are made
   */
  Alternatives(Symbols symbols, InitialFacts facts, int most) {
    this.symbols = symbols;
    this.facts = facts;
    this.most = most;
  }

  /** Whether there would have been more than may be made; what was made is of no use then. */
  boolean isExceeded() {
    return exceeded;
  }

  /**
   * The alternatives; none where the condition can never hold.
   *
   * @param wanted whether the condition has to hold, or must not
   * @param names what variables stand for
   */
  List<Alternative> of(Expression condition, boolean wanted, Map<String, Word> names) {
    Group group = (Group) condition;
    return switch (group.head()) {
      case "" -> wanted ? List.of(Alternative.ALWAYS) : List.of();
      case "and" -> together(each(group.rest(), wanted, names), wanted);
      case "or" -> together(each(group.rest(), wanted, names), !wanted);
      case "not" -> of(group.items().get(1), !wanted, names);
      case "imply" ->
          together(
              List.of(
                  of(group.items().get(1), !wanted, names),
                  of(group.items().get(2), wanted, names)),
              !wanted);
      case "forall" -> quantified(group, wanted, !wanted, names);
      case "exists" -> quantified(group, wanted, wanted, names);
      default -> plain(group, wanted, names);
    };
  }

  private List<List<Alternative>> each(
      List<Expression> conditions, boolean wanted, Map<String, Word> names) {
    return conditions.stream().map(condition -> of(condition, wanted, names)).toList();
  }

  /** All of them at once, or any of them; whatever else there is, what always holds is enough. */
  List<Alternative> together(List<List<Alternative>> parts, boolean all) {
    if (!all && parts.stream().anyMatch(part -> part.contains(Alternative.ALWAYS))) {
      return List.of(Alternative.ALWAYS);
    }
    Map<Object, Alternative> result = new LinkedHashMap<>();
    if (all) {
      result.put(Alternative.ALWAYS, Alternative.ALWAYS);
    }
    for (List<Alternative> part : parts) {
      Map<Object, Alternative> next = all ? new LinkedHashMap<>() : result;
      for (Alternative before : all ? List.copyOf(result.values()) : List.of(Alternative.ALWAYS)) {
        for (Alternative alternative : part) {
          add(before.and(alternative), next);
        }
      }
      result = next;
    }
    return List.copyOf(result.values());
  }

  private void add(Alternative alternative, Map<Object, Alternative> into) {
    if (into.size() < most) {
      into.putIfAbsent(
          List.of(alternative.literals().keySet(), alternative.variables()), alternative);
    } else {
      exceeded = true;
    }
  }

  /**
   * @param some whether one choice of objects is enough
   */
  private List<Alternative> quantified(
      Group group, boolean wanted, boolean some, Map<String, Word> names) {
    List<Expression> list = ((Group) group.items().get(1)).items();
    Expression body = group.items().get(2);
    List<Symbols.Typed> bound = symbols.readTyped(list, true);
    if (!some) {
      return together(
          choices(bound, names).stream().map(choice -> of(body, wanted, choice)).toList(), true);
    }
    Map<String, Word> inside = new HashMap<>(names);
    List<Expression> fresh = new ArrayList<>();
    for (Expression item : list) {
      Expression kept = item;
      if (item instanceof Word word && word.isVariable()) {
        Word renamed = new Word(word.position(), word.text() + "#" + variables++);
        inside.put(word.text(), renamed);
        kept = renamed;
      }
      fresh.add(kept);
    }
    return of(body, wanted, inside).stream()
        .map(one -> new Alternative(one.literals(), joined(fresh, one.variables())))
        .toList();
  }

  private static List<Expression> joined(List<Expression> first, List<Expression> second) {
    List<Expression> all = new ArrayList<>(first);
    all.addAll(second);
    return all;
  }

  /**
   * What the variables may stand for, beside these names: every choice of objects of their types.
   */
  List<Map<String, Word>> choices(List<Symbols.Typed> variables, Map<String, Word> names) {
    List<Map<String, Word>> choices = List.of(names);
    for (Symbols.Typed variable : variables) {
      BitSet objects = symbols.members(variable.types());
      List<Map<String, Word>> longer = new ArrayList<>();
      for (Map<String, Word> choice : choices) {
        objects.stream()
            .forEach(
                object -> {
                  Map<String, Word> with = new HashMap<>(choice);
                  with.put(
                      variable.name().text(),
                      new Word(variable.name().position(), symbols.objectName(object)));
                  longer.add(with);
                });
      }
      choices = longer;
    }
    return choices;
  }

  private List<Alternative> plain(Group group, boolean wanted, Map<String, Word> names) {
    Group named = (Group) named(group, names);
    return switch (named.head()) {
      case "<" -> literal(wanted ? named : renamed(named, ">="));
      case "<=" -> literal(wanted ? named : renamed(named, ">"));
      case ">" -> literal(wanted ? named : renamed(named, "<="));
      case ">=" -> literal(wanted ? named : renamed(named, "<"));
      case "=" -> equal(named, wanted);
      default ->
          switch (facts.known(named)) {
            case HOLDS -> wanted ? List.of(Alternative.ALWAYS) : List.of();
            case LACKS -> wanted ? List.of() : List.of(Alternative.ALWAYS);
            case CHANGES -> literal(wanted ? named : negated(named));
          };
    };
  }

  private List<Alternative> equal(Group group, boolean wanted) {
    if (!(symbols.isTerm(group.items().get(1)) && symbols.isTerm(group.items().get(2)))) {
      return wanted
          ? literal(group)
          : together(List.of(literal(renamed(group, "<")), literal(renamed(group, ">"))), false);
    }
    Word first = (Word) group.items().get(1);
    Word second = (Word) group.items().get(2);
    if (first.isVariable() || second.isVariable()) {
      return literal(wanted ? group : negated(group));
    }
    return first.text().equals(second.text()) == wanted ? List.of(Alternative.ALWAYS) : List.of();
  }

  private static List<Alternative> literal(Expression literal) {
    return List.of(new Alternative(Map.of(literal.text(), literal), List.of()));
  }

  private static Group negated(Group group) {
    return new Group(group.position(), List.of(new Word(group.position(), "not"), group));
  }

  private static Group renamed(Group group, String head) {
    return new Group(
        group.position(),
        List.of(
            new Word(group.items().get(0).position(), head),
            group.items().get(1),
            group.items().get(2)));
  }

  /** With what the variables stand for in their place. */
  static Expression named(Expression expression, Map<String, Word> names) {
    if (expression instanceof Word word) {
      return names.getOrDefault(word.text(), word);
    }
    Group group = (Group) expression;
    return new Group(
        group.position(), group.items().stream().map(item -> named(item, names)).toList());
  }
}
