package org.maestro.planning.pddl;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.StringTokenizer;

/** Runs a plan over the words of domain and problem; shares nothing with the reader or planner. */
final class PlanExecutor {
  private final Map<String, List<?>> actions = new LinkedHashMap<>();
  private final Map<String, String> parents = new HashMap<>();
  private final Map<String, String> objects = new LinkedHashMap<>();
  private final Set<List<?>> state = new HashSet<>();
  private final Map<List<?>, BigDecimal> values = new HashMap<>();
  private final List<?> goal;

  PlanExecutor(String domain, String problem) {
    for (Object section : tree(domain)) {
      if (section instanceof List<?> list && list.get(0).equals(":action")) {
        actions.put((String) list.get(1), list);
      } else if (section instanceof List<?> list && list.get(0).equals(":types")) {
        parents.putAll(typed(list.subList(1, list.size())));
      } else if (section instanceof List<?> list && list.get(0).equals(":constants")) {
        objects.putAll(typed(list.subList(1, list.size())));
      }
    }
    List<?> wanted = List.of();
    for (Object section : tree(problem)) {
      if (section instanceof List<?> list && list.get(0).equals(":objects")) {
        objects.putAll(typed(list.subList(1, list.size())));
      } else if (section instanceof List<?> list && list.get(0).equals(":init")) {
        for (Object fact : list.subList(1, list.size())) {
          List<?> atom = (List<?>) fact;
          if (atom.get(0).equals("=")) {
            values.put((List<?>) atom.get(1), new BigDecimal((String) atom.get(2)));
          } else {
            state.add(atom);
          }
        }
      } else if (section instanceof List<?> list && list.get(0).equals(":goal")) {
        wanted = (List<?>) list.get(1);
      }
    }
    goal = wanted;
  }

  /** Of {@code a b - type c} the type of each. */
  private static Map<String, String> typed(List<?> words) {
    Map<String, String> types = new LinkedHashMap<>();
    List<String> waiting = new ArrayList<>();
    for (int i = 0; i < words.size(); i++) {
      if (words.get(i).equals("-")) {
        String type = words.get(++i).toString();
        waiting.forEach(name -> types.put(name, type));
        waiting.clear();
      } else {
        waiting.add((String) words.get(i));
      }
    }
    waiting.forEach(name -> types.put(name, "object"));
    return types;
  }

  /** Objects of a type, which may be one of several: {@code [either, a, b]}. */
  private List<String> objects(String type) {
    List<String> types = List.of(type.replaceAll("[\\[\\],]", "").split(" "));
    return objects.entrySet().stream()
        .filter(
            object -> {
              String above = object.getValue();
              while (!types.contains(above) && parents.containsKey(above)) {
                above = parents.get(above);
              }
              return types.contains(above) || types.contains("object");
            })
        .map(Map.Entry::getKey)
        .toList();
  }

  private record Situation(Set<List<?>> state, Map<List<?>, BigDecimal> values) {}

  private record Entry(BigDecimal cost, Situation situation) {}

  /**
   * The cost of the cheapest plan, found by trying everything.
   *
   * @return empty when there is none; negative when there are too many states to say
   */
  Optional<BigDecimal> cheapest(int mostStates) {
    List<?> total = List.of("total-cost");
    PriorityQueue<Entry> queue = new PriorityQueue<>((a, b) -> a.cost().compareTo(b.cost()));
    Map<Situation, BigDecimal> best = new HashMap<>();
    List<String> all = groundSteps();
    values.put(total, BigDecimal.ZERO);
    queue.add(new Entry(BigDecimal.ZERO, situation(total)));
    best.put(situation(total), BigDecimal.ZERO);
    while (!queue.isEmpty()) {
      Entry entry = queue.remove();
      if (entry.cost().compareTo(best.get(entry.situation())) > 0) {
        continue;
      }
      take(entry, total);
      if (holds(goal, Map.of())) {
        return Optional.of(entry.cost());
      }
      if (best.size() > mostStates) {
        return Optional.of(BigDecimal.ONE.negate());
      }
      for (String step : all) {
        take(entry, total);
        if (isApplicable(step)) {
          run(step);
          BigDecimal cost = values.get(total);
          Situation after = situation(total);
          BigDecimal known = best.get(after);
          if (known == null || cost.compareTo(known) < 0) {
            best.put(after, cost);
            queue.add(new Entry(cost, after));
          }
        }
      }
    }
    return Optional.empty();
  }

  private Situation situation(List<?> total) {
    Map<List<?>, BigDecimal> others = new HashMap<>();
    values.forEach((function, value) -> others.put(function, value.stripTrailingZeros()));
    others.remove(total);
    return new Situation(new HashSet<>(state), others);
  }

  private void take(Entry entry, List<?> total) {
    state.clear();
    state.addAll(entry.situation().state());
    values.clear();
    values.putAll(entry.situation().values());
    values.put(total, entry.cost());
  }

  private List<String> groundSteps() {
    List<String> steps = new ArrayList<>();
    actions.forEach(
        (name, action) -> {
          List<String> open = List.of("(" + name);
          for (String type : typed((List<?>) part(action, ":parameters")).values()) {
            List<String> longer = new ArrayList<>();
            open.forEach(start -> objects(type).forEach(o -> longer.add(start + " " + o)));
            open = longer;
          }
          open.forEach(step -> steps.add(step + ")"));
        });
    return steps;
  }

  private boolean isApplicable(String step) {
    List<?> action = actions.get(step.substring(1, step.length() - 1).split(" ")[0]);
    return holds((List<?>) part(action, ":precondition"), binding(step));
  }

  /** What the plan costs; fails where it does not hold. */
  BigDecimal cost(List<String> plan) {
    for (String step : plan) {
      run(step);
    }
    assertThat(holds(goal, Map.of())).as("goal").isTrue();
    return values.get(List.of("total-cost"));
  }

  private void run(String step) {
    List<?> action = actions.get(step.substring(1, step.length() - 1).split(" ")[0]);
    Map<String, String> binding = binding(step);
    assertThat(holds((List<?>) part(action, ":precondition"), binding)).as(step).isTrue();
    Changes changes = new Changes(new ArrayList<>(), new ArrayList<>(), new HashMap<>());
    apply((List<?>) part(action, ":effect"), binding, changes);
    changes.deleted().forEach(state::remove);
    state.addAll(changes.added());
    changes
        .amounts()
        .forEach((function, amount) -> values.merge(function, amount, BigDecimal::add));
  }

  private Map<String, String> binding(String step) {
    String[] words = step.substring(1, step.length() - 1).split(" ");
    Map<String, String> binding = new HashMap<>();
    int argument = 1;
    for (String parameter : typed((List<?>) part(actions.get(words[0]), ":parameters")).keySet()) {
      binding.put(parameter, words[argument++]);
    }
    return binding;
  }

  private static Object part(List<?> action, String name) {
    return action.get(action.indexOf(name) + 1);
  }

  /** All effects of a step look at the state before it. */
  private record Changes(
      List<List<?>> added, List<List<?>> deleted, Map<List<?>, BigDecimal> amounts) {}

  private void apply(List<?> effect, Map<String, String> binding, Changes changes) {
    switch ((String) effect.get(0)) {
      case "and" ->
          effect.subList(1, effect.size()).forEach(e -> apply((List<?>) e, binding, changes));
      case "when" -> {
        if (holds((List<?>) effect.get(1), binding)) {
          apply((List<?>) effect.get(2), binding, changes);
        }
      }
      case "forall" ->
          choices((List<?>) effect.get(1), binding)
              .forEach(choice -> apply((List<?>) effect.get(2), choice, changes));
      case "not" -> changes.deleted().add(bound((List<?>) effect.get(1), binding));
      case "decrease" ->
          changes
              .amounts()
              .merge(
                  bound((List<?>) effect.get(1), binding),
                  number(effect.get(2), binding).negate(),
                  BigDecimal::add);
      case "increase" ->
          changes
              .amounts()
              .merge(
                  bound((List<?>) effect.get(1), binding),
                  number(effect.get(2), binding),
                  BigDecimal::add);
      default -> changes.added().add(bound(effect, binding));
    }
  }

  /** Every choice of an object for the one variable. */
  private List<Map<String, String>> choices(List<?> variables, Map<String, String> binding) {
    Map.Entry<String, String> variable = typed(variables).entrySet().iterator().next();
    List<Map<String, String>> choices = new ArrayList<>();
    for (String object : objects(variable.getValue())) {
      Map<String, String> more = new HashMap<>(binding);
      more.put(variable.getKey(), object);
      choices.add(more);
    }
    return choices;
  }

  private BigDecimal number(Object amount, Map<String, String> binding) {
    return amount instanceof String word
        ? new BigDecimal(word)
        : values.get(bound((List<?>) amount, binding));
  }

  private boolean holds(List<?> condition, Map<String, String> binding) {
    return switch ((String) condition.get(0)) {
      case "and" ->
          condition.subList(1, condition.size()).stream()
              .allMatch(c -> holds((List<?>) c, binding));
      case "not" -> !holds((List<?>) condition.get(1), binding);
      case "=" -> bound(condition, binding).get(1).equals(bound(condition, binding).get(2));
      case ">=" ->
          number(condition.get(1), binding).compareTo(number(condition.get(2), binding)) >= 0;
      case "<" ->
          number(condition.get(1), binding).compareTo(number(condition.get(2), binding)) < 0;
      case "<=" ->
          number(condition.get(1), binding).compareTo(number(condition.get(2), binding)) <= 0;
      case "or" ->
          condition.subList(1, condition.size()).stream()
              .anyMatch(c -> holds((List<?>) c, binding));
      case "imply" ->
          !holds((List<?>) condition.get(1), binding) || holds((List<?>) condition.get(2), binding);
      case "exists" ->
          choices((List<?>) condition.get(1), binding).stream()
              .anyMatch(choice -> holds((List<?>) condition.get(2), choice));
      case "forall" ->
          choices((List<?>) condition.get(1), binding).stream()
              .allMatch(choice -> holds((List<?>) condition.get(2), choice));
      default -> state.contains(bound(condition, binding));
    };
  }

  private static List<?> bound(List<?> atom, Map<String, String> binding) {
    return atom.stream().map(term -> (Object) binding.getOrDefault(term, (String) term)).toList();
  }

  private static List<?> tree(String text) {
    StringTokenizer tokens =
        new StringTokenizer(text.replaceAll(";[^\n]*", "").toLowerCase(), "() \n\t", true);
    List<List<Object>> open = new ArrayList<>();
    open.add(new ArrayList<>());
    while (tokens.hasMoreTokens()) {
      String token = tokens.nextToken();
      if (token.equals("(")) {
        open.add(new ArrayList<>());
      } else if (token.equals(")")) {
        List<Object> done = open.remove(open.size() - 1);
        open.get(open.size() - 1).add(done);
      } else if (!token.isBlank()) {
        open.get(open.size() - 1).add(token);
      }
    }
    return (List<?>) open.get(0).get(0);
  }
}
