package org.maestro.planning.pddl;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.StringTokenizer;

/** Runs a plan over the words of domain and problem; shares nothing with the reader or planner. */
final class PlanExecutor {
  private final Map<String, List<?>> actions = new HashMap<>();
  private final Set<List<?>> state = new HashSet<>();
  private final Map<List<?>, BigDecimal> values = new HashMap<>();
  private final List<?> goal;

  PlanExecutor(String domain, String problem) {
    for (Object section : tree(domain)) {
      if (section instanceof List<?> list && list.get(0).equals(":action")) {
        actions.put((String) list.get(1), list);
      }
    }
    List<?> wanted = List.of();
    for (Object section : tree(problem)) {
      if (section instanceof List<?> list && list.get(0).equals(":init")) {
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

  /** What the plan costs; fails where it does not hold. */
  BigDecimal cost(List<String> plan) {
    for (String step : plan) {
      run(step);
    }
    assertThat(holds(goal, Map.of())).as("goal").isTrue();
    return values.get(List.of("total-cost"));
  }

  private void run(String step) {
    String[] words = step.substring(1, step.length() - 1).split(" ");
    List<?> action = actions.get(words[0]);
    Map<String, String> binding = new HashMap<>();
    int argument = 1;
    for (Object word : (List<?>) part(action, ":parameters")) {
      if (((String) word).startsWith("?")) {
        binding.put((String) word, words[argument++]);
      }
    }
    assertThat(holds((List<?>) part(action, ":precondition"), binding)).as(step).isTrue();
    List<List<?>> added = new ArrayList<>();
    apply((List<?>) part(action, ":effect"), binding, added);
    state.addAll(added);
  }

  private static Object part(List<?> action, String name) {
    return action.get(action.indexOf(name) + 1);
  }

  private void apply(List<?> effect, Map<String, String> binding, List<List<?>> added) {
    switch ((String) effect.get(0)) {
      case "and" ->
          effect.subList(1, effect.size()).forEach(e -> apply((List<?>) e, binding, added));
      case "not" -> state.remove(bound((List<?>) effect.get(1), binding));
      case "increase" ->
          values.merge(
              bound((List<?>) effect.get(1), binding),
              number(effect.get(2), binding),
              BigDecimal::add);
      default -> added.add(bound(effect, binding));
    }
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
      case "<=" ->
          number(condition.get(1), binding).compareTo(number(condition.get(2), binding)) <= 0;
      case "exists" -> {
        String variable = (String) ((List<?>) condition.get(1)).get(0);
        yield state.stream()
            .flatMap(List::stream)
            .distinct()
            .anyMatch(
                object -> {
                  Map<String, String> more = new HashMap<>(binding);
                  more.put(variable, object.toString());
                  return holds((List<?>) condition.get(2), more);
                });
      }
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
