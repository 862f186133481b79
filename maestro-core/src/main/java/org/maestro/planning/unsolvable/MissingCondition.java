package org.maestro.planning.unsolvable;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.maestro.planning.ground.Atom;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.ground.Literal;
import org.maestro.planning.ground.Reach;
import org.maestro.planning.ground.Schema;

/**
 * Follows a goal that is out of reach back to the condition at which it fails: from what is not
 * reached to the step that would bring it about and lacks least, to what that lacks, and so on.
 */
final class MissingCondition {
  private static final int MOST_STEPS = 8;
  private static final int MOST_ATTEMPTS = 5_000;

  /** What no step changes weighs as much as so many conditions that one could. */
  private static final int FIXED = 10;

  private final LiftedTask task;
  private final Reach reach;
  private final Words words;
  private final Set<Integer> changing = new HashSet<>();

  /**
   * A step that would bring something about.
   *
   * @param lacking what it lacks
   * @param weight of what it lacks
   */
  private record Attempt(Schema schema, int[] binding, List<Literal> lacking, int weight) {}

  MissingCondition(LiftedTask task, Reach reach) {
    this.task = task;
    this.reach = reach;
    this.words = new Words(task);
    task.schemas().stream()
        .flatMap(schema -> Stream.concat(schema.additions().stream(), schema.deletions().stream()))
        .forEach(atom -> changing.add(atom.symbol()));
  }

  /** One for each part of the goal that is out of reach, of itself. */
  List<String> sentences(Schema goal) {
    int[] open = Binding.open(goal);
    return lacking(goal, open).stream()
        .map(part -> sentence(part, open, List.of()))
        .distinct()
        .toList();
  }

  private List<Literal> lacking(Schema schema, int[] binding) {
    return schema.conditions().stream().filter(part -> !isInReach(part, binding)).toList();
  }

  private boolean isInReach(Literal literal, int[] binding) {
    int symbol = literal.atom().symbol();
    int[] objects = Binding.objects(literal.atom(), binding);
    return literal.positive()
        ? reach.mayHold(symbol, objects)
        : IntStream.of(objects).anyMatch(object -> object < 0) || reach.mayLack(symbol, objects);
  }

  /**
   * @param sofar the steps, from the goal on, for the last of which it is needed
   */
  private String sentence(Literal lacking, int[] binding, List<String> sofar) {
    String condition = words.literal(lacking, binding);
    Optional<Attempt> attempt =
        lacking.positive() && sofar.size() < MOST_STEPS
            ? nearest(lacking.atom().symbol(), Binding.objects(lacking.atom(), binding), sofar)
            : Optional.empty();
    if (attempt.isEmpty()) {
      return "needed: %s%s; nothing brings it about"
          .formatted(
              condition, sofar.stream().map(step -> ", for " + step).collect(Collectors.joining()));
    }
    Attempt nearest = attempt.get();
    List<String> longer = new ArrayList<>();
    longer.add(words.step(nearest.schema(), nearest.binding()));
    longer.addAll(sofar);
    return sentence(nearest.lacking().get(0), nearest.binding(), longer);
  }

  /**
   * Of each step the attempt that lacks least, and of those the one that lacks what can never be;
   * none where no step would do, or only those that are among these already.
   */
  private Optional<Attempt> nearest(int predicate, int[] objects, List<String> sofar) {
    List<Attempt> ofSteps = new ArrayList<>();
    for (Schema schema : task.schemas()) {
      for (Atom added : schema.additions()) {
        if (added.symbol() == predicate) {
          Binding.with(schema, added, objects)
              .flatMap(binding -> nearest(schema, binding, sofar))
              .ifPresent(ofSteps::add);
        }
      }
    }
    return ofSteps.stream()
        .min(
            Comparator.<Attempt>comparingInt(attempt -> attempt.lacking().size())
                .thenComparing(Comparator.comparingInt(Attempt::weight).reversed()));
  }

  private Optional<Attempt> nearest(Schema schema, int[] binding, List<String> sofar) {
    List<Attempt> attempts = new ArrayList<>();
    addLacking(schema, binding, attempts);
    return attempts.stream()
        .filter(attempt -> !sofar.contains(words.step(schema, attempt.binding())))
        .min(Comparator.comparingInt(Attempt::weight));
  }

  /**
   * Adds the attempts that lack something: where no condition does by itself, objects are chosen
   * for what is open until one does.
   */
  private void addLacking(Schema schema, int[] binding, List<Attempt> attempts) {
    List<Literal> lacking = lacking(schema, binding);
    int open = lacking.isEmpty() ? Binding.firstOpen(schema, binding) : -1;
    if (!lacking.isEmpty()) {
      int weight =
          lacking.stream().mapToInt(part -> changing.contains(symbol(part)) ? 1 : FIXED).sum();
      attempts.add(new Attempt(schema, binding, lacking, weight));
    } else if (open >= 0) {
      schema.domains().get(open).stream()
          .takeWhile(object -> attempts.size() < MOST_ATTEMPTS)
          .forEach(
              object -> {
                int[] closer = binding.clone();
                closer[open] = object;
                addLacking(schema, closer, attempts);
              });
    }
  }

  private static int symbol(Literal literal) {
    return literal.atom().symbol();
  }
}
