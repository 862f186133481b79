package org.maestro.coordination.story;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.facts.ReckonedFromPlaces;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.planning.api.PlanningResult.Cure;
import org.maestro.planning.api.PlanningResult.Explanation;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Extent;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Formula.Relation;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** Says in plain words what stands in the way of a goal, and what would help. */
public final class ObstacleSentences {
  /** So many are told; more of them nobody reads. */
  private static final int MOST_WAYS = 5;

  private final Home home;
  private final Facts facts;
  private final Function<Expression.Fluent, Optional<Belief>> origins;
  private final Set<String> gone;
  private final Sentences sentences;

  /**
   * @param facts what is known, for the numbers of comparisons
   */
  public ObstacleSentences(Home home, Facts facts) {
    this(home, facts, fluent -> Optional.empty(), Set.of());
  }

  /**
   * @param known for the numbers of comparisons, and for who measured them
   */
  public ObstacleSentences(Home home, Snapshot known) {
    this(home, known, known::belief, Set.of());
  }

  /**
   * @param gone who is not there, and could do nothing
   */
  private ObstacleSentences(
      Home home,
      Facts facts,
      Function<Expression.Fluent, Optional<Belief>> origins,
      Set<String> gone) {
    this.home = home;
    this.facts = facts;
    this.origins = origins;
    this.gone = gone;
    this.sentences = new Sentences(home.vocabulary());
  }

  /** One text for each obstacle. */
  public List<String> all(Explanation explanation) {
    Set<String> absent =
        explanation.obstacles().stream()
            .filter(obstacle -> obstacle.kind() == Kind.MEMBER && !isThere(obstacle))
            .map(Obstacle::condition)
            .collect(Collectors.toSet());
    ObstacleSentences together = new ObstacleSentences(home, facts, origins, absent);
    return explanation.obstacles().stream().map(together::obstacle).toList();
  }

  /** What is needed, for what, what is possible, and what would help. */
  public String obstacle(Obstacle obstacle) {
    String purpose = obstacle.neededBy().map(step -> ", so that " + step(step)).orElse("");
    return capital(need(obstacle, purpose)) + "." + cures(obstacle);
  }

  private String need(Obstacle obstacle, String purpose) {
    return switch (obstacle.kind()) {
      case MEMBER ->
          obstacle.condition()
              + (isThere(obstacle)
                  ? " is needed and cannot be counted on ("
                  : " is needed and not there (")
              + obstacle.possible()
              + ")";
      case STEP ->
          step(obstacle.subject().orElseThrow())
              + ": that is needed, and not to be had ("
              + obstacle.possible()
              + ")";
      case GOAL -> theGoal(obstacle);
      case EXCLUDED ->
          fact(obstacle)
              + ": that is needed"
              + purpose
              + ", and it is not so; looked for in "
              + String.join(", ", obstacle.possible().split(" "));
      case FACT ->
          isUnknownNumber(obstacle)
              ? "it is not known that " + fact(obstacle) + purpose + "; nobody can find out"
              : "it is needed that " + fact(obstacle) + purpose + ", and " + otherwise(obstacle);
      case UNKNOWN ->
          "it is not known that "
              + fact(obstacle)
              + purpose
              + "; "
              + asThingsAre(obstacle, "nobody can find out");
      case NUMBER -> number(obstacle, purpose);
    };
  }

  /** Whoever moves things may bring it about without knowing. */
  private String theGoal(Obstacle obstacle) {
    Formula goal = formula(obstacle);
    if (!new ReckonedFromPlaces(home.vocabulary()).isIn(goal, facts)) {
      return asThingsAre(obstacle, "nobody can bring it about that ") + fact(obstacle);
    }
    boolean known = new Evaluation(facts).truth(goal, Map.of()) != Truth.UNKNOWN;
    return (known ? "it is not so now that " : "it is not known whether ")
        + fact(obstacle)
        + ", and no description of a device says what it does to that";
  }

  /** Of numbers nothing is so because nobody has said anything. */
  private boolean isUnknownNumber(Obstacle obstacle) {
    return formula(obstacle) instanceof Formula.Comparison comparison
        && new Evaluation(facts).truth(comparison, Map.of()) == Truth.UNKNOWN;
  }

  /** Others, who are not there or refuse, might change it. */
  private static String asThingsAre(Obstacle obstacle, String claim) {
    return obstacle.extent() == Extent.LIMIT_NOW ? "as things are now " + claim : claim;
  }

  /** What is said of a member that is there is said of what it does. */
  private static boolean isThere(Obstacle member) {
    return member.possible().startsWith("it ");
  }

  private String otherwise(Obstacle obstacle) {
    return switch (obstacle.possible()) {
      case "false" -> "it is not so";
      case "true", "known" -> "it is";
      default -> sentences.fact(formula(obstacle.possible()));
    };
  }

  private String number(Obstacle obstacle, String purpose) {
    if (!(formula(obstacle) instanceof Formula.Comparison comparison)) {
      return "it is needed that " + fact(obstacle) + purpose + ", and it is not so";
    }
    return clause(comparison, " has to be ") + purpose + ", and " + possible(obstacle, comparison);
  }

  /** A limit is told only where it is one. */
  private String possible(Obstacle obstacle, Formula.Comparison comparison) {
    double possible = Double.parseDouble(obstacle.possible());
    String number = Sentences.number(possible) + unit(comparison);
    String limit = isMore(comparison) ? number + " at most" : "no less than " + number;
    if (obstacle.extent() != Extent.KNOWN && isMet(comparison, possible)) {
      return "it can be " + number + ", but not together with all else that is needed";
    }
    return switch (obstacle.extent()) {
      case KNOWN -> "it is " + number + measured(comparison, possible);
      case LIMIT, LIMIT_NOW ->
          isNow(comparison, possible)
              ? "it is "
                  + number
                  + measured(comparison, possible)
                  + ", and "
                  + asThingsAre(obstacle, "nobody can make it ")
                  + (isMore(comparison) ? "more" : "less")
              : asThingsAre(obstacle, "it can be ") + limit;
      case FOUND ->
          "no way was found to bring it " + (isMore(comparison) ? "above " : "below ") + number;
    };
  }

  /** Nothing that anybody does changes it; by itself it may change. */
  private boolean isNow(Formula.Comparison comparison, double possible) {
    return comparison.left() instanceof Expression.Fluent fluent
        && facts.number(fluent).equals(OptionalDouble.of(possible));
  }

  /** A measurement is one device's word; another may say otherwise. */
  private String measured(Formula.Comparison comparison, double possible) {
    return isNow(comparison, possible) && comparison.left() instanceof Expression.Fluent fluent
        ? origins
            .apply(fluent)
            .map(Belief::source)
            .filter(source -> source.kind() == Source.Kind.OBSERVED)
            .map(source -> " as " + source.agent() + " measured")
            .orElse("")
        : "";
  }

  private static boolean isMet(Formula.Comparison comparison, double possible) {
    if (!(comparison.right() instanceof Expression.OfTerm ofTerm)
        || !(ofTerm.term() instanceof Term.Number wanted)) {
      return false;
    }
    return switch (comparison.relation()) {
      case AT_LEAST -> possible >= wanted.value();
      case GREATER -> possible > wanted.value();
      case AT_MOST -> possible <= wanted.value();
      case LESS -> possible < wanted.value();
      case EQUAL -> false;
    };
  }

  private String clause(Formula.Comparison comparison, String verb) {
    return side(comparison.left())
        + verb
        + relation(comparison.relation())
        + side(comparison.right())
        + (comparison.right() instanceof Expression.Fluent fluent
            ? known(fluent)
            : unit(comparison));
  }

  private String side(Expression expression) {
    return expression instanceof Expression.Fluent fluent
        ? sentences.quantity(fluent)
        : Sentences.value(expression);
  }

  private String known(Expression.Fluent fluent) {
    OptionalDouble number = facts.number(fluent);
    return number.isPresent()
        ? " (" + Sentences.number(number.getAsDouble()) + sentences.unit(fluent) + ")"
        : "";
  }

  private String unit(Formula.Comparison comparison) {
    return comparison.left() instanceof Expression.Fluent fluent ? sentences.unit(fluent) : "";
  }

  private static boolean isMore(Formula.Comparison comparison) {
    return comparison.relation() == Relation.AT_LEAST || comparison.relation() == Relation.GREATER;
  }

  private static String relation(Relation relation) {
    return relation == Relation.EQUAL ? "" : relation.inWords() + " ";
  }

  private String cures(Obstacle obstacle) {
    StringBuilder text = new StringBuilder();
    if (obstacle.kind() != Kind.GOAL) {
      // Steps that differ in an amount only read the same.
      Set<String> ways = new LinkedHashSet<>(List.of(cure(obstacle)));
      for (Cure cure : obstacle.cures()) {
        ways.add(cure.conditions().stream().map(this::cure).collect(Collectors.joining(" and ")));
      }
      text.append(" It would do if ")
          .append(ways.stream().limit(MOST_WAYS).collect(Collectors.joining(", or if ")));
      if (ways.size() > MOST_WAYS) {
        text.append(", or in %d other ways".formatted(ways.size() - MOST_WAYS));
      }
      text.append('.');
    }
    return text.toString();
  }

  private String cure(Obstacle wanted) {
    return switch (wanted.kind()) {
      case MEMBER ->
          wanted.condition()
              + (isThere(wanted) ? " could be counted on (" : " were there (")
              + wanted.possible()
              + ")";
      case STEP ->
          wanted.subject().map(StepKey::member).orElse("somebody")
              + (wanted.subject().map(StepKey::member).filter(gone::contains).isPresent()
                  ? " were there and"
                  : "")
              + " did it after all ("
              + step(wanted.subject().orElseThrow())
              + ")";
      case UNKNOWN ->
          formula(wanted) instanceof Formula.Comparison comparison
              ? clause(comparison, " were known to be ")
              : unreal(fact(wanted));
      case NUMBER ->
          formula(wanted) instanceof Formula.Comparison comparison
              ? enough(comparison, wanted)
              : unreal(fact(wanted));
      default -> unreal(fact(wanted));
    };
  }

  private String enough(Formula.Comparison comparison, Obstacle wanted) {
    if (comparison.right() instanceof Expression.Fluent limit
        && comparison.left() instanceof Expression.Fluent fluent) {
      OptionalDouble least = facts.number(fluent);
      return sentences.quantity(limit)
          + " were "
          + (isMore(comparison) ? "at most " : "at least ")
          + (least.isPresent() ? Sentences.number(least.getAsDouble()) : "enough")
          + sentences.unit(fluent);
    }
    return wanted.missing().isEmpty()
        ? clause(comparison, " were ")
        : side(comparison.left())
            + " were "
            + Sentences.number(wanted.missing().getAsDouble())
            + unit(comparison)
            + (isMore(comparison) ? " higher" : " lower");
  }

  /** A fact as it would be if it were so. */
  private static String unreal(String fact) {
    return fact.replaceFirst(" is ", " were ")
        .replaceFirst(" cannot ", " could not ")
        .replaceFirst(" can ", " could ");
  }

  private String fact(Obstacle obstacle) {
    Formula formula = formula(obstacle);
    if (formula instanceof Formula.Not not
        && not.operand() instanceof Formula.UnknownNumber unknown) {
      return sentences.quantity(unknown.fluent()) + " is known";
    }
    if (formula instanceof Formula.Comparison comparison) {
      return clause(comparison, " is ");
    }
    return sentences.fact(formula);
  }

  private Formula formula(Obstacle obstacle) {
    return formula(obstacle.condition());
  }

  private Formula formula(String text) {
    return SlParser.formula(text, home.vocabulary()::isFluent);
  }

  private String step(StepKey key) {
    return Optional.ofNullable(home.devices().get(key.member())).stream()
        .flatMap(device -> device.features().stream())
        .filter(feature -> feature.name().equals(key.feature()))
        .findFirst()
        .map(
            feature ->
                sentences.step(
                    new Step(0, key.member(), feature, key.bindings(), 0, 0, true, Set.of())))
        .orElse(key.member() + " does " + key.feature());
  }

  /** A name stays as it is written. */
  private String capital(String text) {
    String first = text.split("[ ,.:;]", 2)[0];
    if (home.individuals().containsKey(first)) {
      return text;
    }
    return Character.toUpperCase(text.charAt(0)) + text.substring(1);
  }
}
