package org.maestro.planning.pddl;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.planning.ground.Schema;
import org.maestro.planning.pddl.Alternatives.Alternative;
import org.maestro.planning.pddl.Expression.Group;
import org.maestro.planning.pddl.Expression.Position;
import org.maestro.planning.pddl.Expression.Word;

/**
 * Actions with conditional effects, and with conditions that are true in several ways, as several
 * plain ones of one name: one for each way in which the action can go. Where those would be many,
 * parameters are replaced by objects, of which more is known.
 */
final class PlainActions {
  /** Beyond so many ways of one action its parameters are replaced by objects. */
  private static final int MANY = 32;

  /** Of one action at most. */
  private static final int MOST = 4_096;

  private final Symbols symbols;
  private final InitialFacts facts;
  private final String name;
  private final Position position;
  private final Optional<Group> parameters;
  private final Expression condition;
  private final Expression effect;
  private final List<Schema> schemas = new ArrayList<>();

  /** A conditional effect. */
  private record When(Expression condition, Map<String, Word> names, List<Expression> effects) {}

  /** An effect in parts: what always happens, and what under conditions; by condition. */
  private record Parts(List<Expression> always, Map<String, When> conditional) {}

  /**
   * @param position where the action's name stands
   * @param condition understood before, as is the effect
   */
  PlainActions(
      Symbols symbols,
      InitialFacts facts,
      String name,
      Position position,
      Optional<Group> parameters,
      Expression condition,
      Expression effect) {
    this.symbols = symbols;
    this.facts = facts;
    this.name = name;
    this.position = position;
    this.parameters = parameters;
    this.condition = condition;
    this.effect = effect;
  }

  /**
   * The actions.
   *
   * @throws PddlException when they are too many
   */
  List<Schema> all() {
    make(Map.of());
    return schemas;
  }

  private void make(Map<String, Word> bound) {
    Alternatives alternatives = new Alternatives(symbols, facts, MANY);
    Parts parts = parts(bound, alternatives);
    List<Alternative> ways = ways(bound, parts, alternatives);
    if (alternatives.isExceeded()) {
      Optional<Symbols.Typed> next = telling(bound, parts);
      if (next.isPresent()) {
        alternatives.choices(List.of(next.get()), bound).forEach(this::make);
        return;
      }
      alternatives = new Alternatives(symbols, facts, MOST);
      ways = ways(bound, parts, alternatives);
      if (alternatives.isExceeded()) {
        throw tooMany();
      }
    }
    for (Alternative way : ways) {
      if (schemas.size() == MOST) {
        throw tooMany();
      }
      schemas.add(schema(bound, way, parts));
    }
  }

  private PddlException tooMany() {
    return position.error(
        "%s can go in more than %d ways by its or, forall and when; divide it into several."
            .formatted(name, MOST));
  }

  /**
   * Each way begins with the action's own condition; whether a conditional effect happens is the
   * question of the condition's key, by which the way knows it again.
   */
  private List<Alternative> ways(Map<String, Word> bound, Parts parts, Alternatives alternatives) {
    List<List<Alternative>> all = new ArrayList<>();
    all.add(alternatives.of(condition, true, bound));
    parts
        .conditional()
        .forEach(
            (key, when) -> {
              List<Alternative> either = new ArrayList<>();
              alternatives.of(when.condition(), true, when.names()).stream()
                  .map(one -> one.and(marked(key, when)))
                  .forEach(either::add);
              either.addAll(alternatives.of(when.condition(), false, when.names()));
              all.add(either);
            });
    return alternatives.together(all, true);
  }

  private static Alternative marked(String key, When when) {
    return new Alternative(
        Map.of(key, new Group(when.condition().position(), List.of())), List.of());
  }

  private Parts parts(Map<String, Word> bound, Alternatives alternatives) {
    Parts parts = new Parts(new ArrayList<>(), new LinkedHashMap<>());
    divide(effect, bound, Optional.empty(), alternatives, parts);
    return parts;
  }

  private void divide(
      Expression part,
      Map<String, Word> names,
      Optional<When> under,
      Alternatives alternatives,
      Parts parts) {
    Group group = (Group) part;
    switch (group.head()) {
      case "and" -> group.rest().forEach(one -> divide(one, names, under, alternatives, parts));
      case "forall" -> {
        List<Symbols.Typed> variables =
            symbols.readTyped(((Group) group.items().get(1)).items(), true);
        for (Map<String, Word> choice : alternatives.choices(variables, names)) {
          divide(group.items().get(2), choice, under, alternatives, parts);
        }
      }
      case "when" -> {
        String key = "when " + Alternatives.named(group.items().get(1), names).text();
        When when =
            parts
                .conditional()
                .computeIfAbsent(
                    key, absent -> new When(group.items().get(1), names, new ArrayList<>()));
        divide(group.items().get(2), names, Optional.of(when), alternatives, parts);
      }
      default -> {
        Expression named = Alternatives.named(group, names);
        if (!isOfWrongThings((Group) named)) {
          under.map(When::effects).orElse(parts.always()).add(named);
        }
      }
    }
  }

  /** Nobody could tell whether it holds. */
  private boolean isOfWrongThings(Group plain) {
    Group atom = plain.head().equals("not") ? (Group) plain.items().get(1) : plain;
    return symbols.predicates.containsKey(atom.head())
        && facts.known(atom) == InitialFacts.Known.LACKS;
  }

  /** The parameter that stands most often beside what no action changes. */
  private Optional<Symbols.Typed> telling(Map<String, Word> bound, Parts parts) {
    Map<String, Integer> mentions = new HashMap<>();
    count(condition, mentions);
    parts.conditional().values().forEach(when -> count(when.condition(), mentions));
    return parameters.stream()
        .flatMap(list -> symbols.readTyped(list.items(), true).stream())
        .filter(typed -> !bound.containsKey(typed.name().text()))
        .filter(typed -> mentions.containsKey(typed.name().text()))
        .max(Comparator.comparing(typed -> mentions.get(typed.name().text())));
  }

  private void count(Expression expression, Map<String, Integer> mentions) {
    if (expression instanceof Group group) {
      if (symbols.predicates.containsKey(group.head()) && facts.isStatic(group.head())
          || group.head().equals("=")) {
        group
            .rest()
            .forEach(
                item -> {
                  if (item instanceof Word word) {
                    mentions.merge(word.text(), 1, Integer::sum);
                  }
                });
      } else {
        group.items().forEach(item -> count(item, mentions));
      }
    }
  }

  private Schema schema(Map<String, Word> bound, Alternative way, Parts parts) {
    SchemaReader reader = new SchemaReader(symbols, name, position);
    parameters.ifPresent(reader::parameters);
    bound.forEach(reader::bind);
    reader.addParameters(way.variables());
    way.literals()
        .forEach(
            (key, literal) -> {
              When when = parts.conditional().get(key);
              if (when == null) {
                reader.condition(literal);
              } else {
                when.effects().forEach(reader::effect);
              }
            });
    parts.always().forEach(reader::effect);
    return reader.done();
  }
}
