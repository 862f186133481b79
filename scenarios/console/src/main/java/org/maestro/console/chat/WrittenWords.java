package org.maestro.console.chat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.maestro.coordination.api.GoalCheck;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.dialogue.Reading;
import org.maestro.dialogue.Utterance;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * Reads what is written: MAESTRO-SL as it is, or the name of what is to be so and the things of
 * which it is said, in any of the home's words: {@code nextTo Cup Bob}, {@code the cup next to me},
 * {@code illuminance here 100}. A question mark at either end makes it a question.
 */
final class WrittenWords {
  private static final int MOST_NEAR = 4;
  private static final Pattern WORD = Pattern.compile("[A-Za-z][\\w-]*");

  private final Home home;
  private final HomeWords words;

  WrittenWords(Home home) {
    this.home = home;
    this.words = new HomeWords(home);
  }

  Reading read(Utterance utterance) {
    String text = utterance.text().strip();
    boolean isQuestion = text.startsWith("?") || text.endsWith("?");
    String said = text.replaceAll("^\\?\\s*|\\s*\\?$", "");
    if (said.isBlank()) {
      return new Reading.Unclear(
          "Say what is to be so, in MAESTRO-SL or in words%s.".formatted(words.example()),
          List.of());
    }
    Reading reading =
        said.startsWith("(") ? formula(said, isQuestion) : worded(said, isQuestion, utterance);
    return reading instanceof Reading.Goal goal ? checked(goal, said) : reading;
  }

  private static Reading formula(String said, boolean isQuestion) {
    return isQuestion ? new Reading.Question(said) : new Reading.Goal(said);
  }

  private Reading checked(Reading.Goal goal, String said) {
    try {
      new GoalCheck(home).check(SlParser.formula(goal.formula(), home.vocabulary()::isFluent));
      return goal;
    } catch (SlSyntaxException | InvalidGoalException e) {
      return new Reading.Unclear(String.valueOf(e.getMessage()), near(said));
    }
  }

  /** The sentence again, with an unknown word made the known one that is next to it. */
  List<String> near(String said) {
    List<String> near = new ArrayList<>();
    Matcher word = WORD.matcher(said);
    while (word.find() && near.size() < MOST_NEAR) {
      String found = word.group();
      boolean isVariable = word.start() > 0 && said.charAt(word.start() - 1) == '?';
      Optional<String> meant = words.near(found).filter(other -> !isVariable);
      if (meant.isPresent() && !meant.get().equals(found)) {
        near.add(said.substring(0, word.start()) + meant.get() + said.substring(word.end()));
      }
    }
    return near;
  }

  private Reading worded(String said, boolean isQuestion, Utterance utterance) {
    List<HomeWords.Part> parts = words.parts(said, utterance);
    Optional<String> unknown = first(parts, HomeWords.Part.Unknown.class).map(one -> one.word());
    List<HomeWords.Part.Things> things =
        parts.stream()
            .filter(HomeWords.Part.Things.class::isInstance)
            .map(HomeWords.Part.Things.class::cast)
            .toList();
    if (unknown.isPresent()) {
      return new Reading.Unclear(
          "I do not know the word \"%s\".".formatted(unknown.get()),
          Stream.concat(near(said).stream(), filled(things)).limit(MOST_NEAR).toList());
    }
    List<PredicateDeclaration> predicates =
        parts.stream()
            .filter(HomeWords.Part.Predicate.class::isInstance)
            .map(part -> ((HomeWords.Part.Predicate) part).declaration())
            .toList();
    if (predicates.size() != 1) {
      return new Reading.Unclear(
          predicates.isEmpty()
              ? "No word of that says what is to be so; say it in words of the home%s."
                  .formatted(words.example())
              : "That says several things at once; say one after the other.",
          filled(things).limit(MOST_NEAR).toList());
    }
    return of(
        predicates.get(0), things, first(parts, HomeWords.Part.Amount.class), said, isQuestion);
  }

  private static <T> Optional<T> first(List<HomeWords.Part> parts, Class<T> kind) {
    return parts.stream().filter(kind::isInstance).map(kind::cast).findFirst();
  }

  /** What could be so of these things. */
  private Stream<String> filled(List<HomeWords.Part.Things> things) {
    return things.isEmpty()
        ? Stream.of()
        : words.takingThings(things).stream().map(predicate -> atom(predicate, things));
  }

  private static String atom(PredicateDeclaration predicate, List<HomeWords.Part.Things> things) {
    StringBuilder atom = new StringBuilder("(").append(predicate.name());
    for (int i = 0; i < predicate.parameters().size(); i++) {
      atom.append(' ')
          .append(
              i < things.size()
                  ? HomeWords.fitting(things.get(i), predicate.parameters().get(i).className())
                  : "?" + predicate.parameters().get(i).name());
    }
    return atom.append(')').toString();
  }

  private static Reading of(
      PredicateDeclaration predicate,
      List<HomeWords.Part.Things> things,
      Optional<HomeWords.Part.Amount> amount,
      String said,
      boolean isQuestion) {
    int wanted = predicate.parameters().size();
    if (things.size() > wanted) {
      return new Reading.Unclear(
          "That names %d things, and %s is said of %d: %s."
              .formatted(things.size(), predicate.name(), wanted, predicate.form()),
          List.of());
    }
    String atom = atom(predicate, things);
    if (isQuestion) {
      return new Reading.Question(
          amount
              .filter(number -> predicate.fluent())
              .map(number -> "(>= %s %s)".formatted(atom, number.number()))
              .orElse(atom));
    }
    if (things.size() < wanted) {
      return new Reading.Unfinished(
          said, predicate.parameters().get(things.size()).className().orElse("Thing"));
    }
    if (!predicate.fluent()) {
      return new Reading.Goal(atom);
    }
    return amount
        .<Reading>map(number -> new Reading.Goal("(>= %s %s)".formatted(atom, number.number())))
        .orElseGet(() -> new Reading.Unfinished(said, ""));
  }

  /** Some of the things of a class, by their names. */
  List<String> choices(String className) {
    return className.isEmpty() ? List.of() : words.ofClass(className);
  }
}
