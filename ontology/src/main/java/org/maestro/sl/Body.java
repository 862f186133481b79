package org.maestro.sl;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * The body of an action script: what is to be done, in which order, and on which condition (ADE,
 * 4.1; A58). Variables are those of the script's parameters, and those that {@code let} and {@code
 * foreach} bring; a formula may have variables of its own under quantifiers.
 */
public sealed interface Body {

  /** The steps that it is made of, in the order in which they are written. */
  default List<Body> parts() {
    return List.of();
  }

  /** One after the other. */
  record Seq(List<Body> parts) implements Body {
    public Seq {
      parts = List.copyOf(parts);
    }
  }

  /** Side by side; over when all are. When one fails the others are called off. */
  record Par(List<Body> parts) implements Body {
    public Par {
      parts = List.copyOf(parts);
    }
  }

  /** What is not known to be so is not so. */
  record If(Formula condition, Body then, Optional<Body> otherwise) implements Body {
    @Override
    public List<Body> parts() {
      return otherwise.map(other -> List.of(then, other)).orElse(List.of(then));
    }
  }

  /**
   * @param most how often at most; it fails when the condition holds still
   */
  record While(Formula condition, Body body, OptionalInt most) implements Body {
    @Override
    public List<Body> parts() {
      return List.of(body);
    }
  }

  /** For each individual of which the condition is known to hold, one after the other. */
  record ForEach(TypedVariable variable, Formula condition, Body body) implements Body {
    @Override
    public List<Body> parts() {
      return List.of(body);
    }
  }

  /** The variable stands for what the source gives, in the parts that follow. */
  record Let(String variable, Source source, List<Body> parts) implements Body {
    public Let {
      parts = List.copyOf(parts);
    }
  }

  /**
   * @param recoveries the first whose reason is in what went wrong is done instead
   * @param last done in any case at the end, also when the script is cancelled
   */
  record Try(Body body, List<Recovery> recoveries, Optional<Body> last) implements Body {
    public Try {
      recoveries = List.copyOf(recoveries);
    }

    @Override
    public List<Body> parts() {
      return Stream.of(Stream.of(body), recoveries.stream().map(Recovery::body), last.stream())
          .flatMap(parts -> parts)
          .toList();
    }
  }

  /**
   * @param reason a part of the sentence that tells what went wrong; empty: whatever it was
   */
  record Recovery(Optional<String> reason, Body body) {}

  /** A goal, planned over all devices. */
  record Achieve(Formula goal) implements Body {}

  /**
   * A feature of one member, called once.
   *
   * @param parameters by name; what is left out is chosen so that the feature can be called
   */
  record Do(String feature, Term member, Map<String, Term> parameters) implements Body {
    public Do {
      parameters = Map.copyOf(new LinkedHashMap<>(parameters));
    }
  }

  /**
   * A component of a member is nobody else's while the parts are done, but for who goes first, at a
   * safe point.
   *
   * @param parts none only in the step of a {@code while}: for as long as its condition holds
   */
  record Hold(Term member, String component, List<Body> parts) implements Body {
    public Hold {
      parts = List.copyOf(parts);
    }
  }

  /** Another script, with these for its parameters. */
  record Run(String script, List<Term> arguments) implements Body, Body.Source {
    public Run {
      arguments = List.copyOf(arguments);
    }
  }

  /**
   * A sentence for a person, or for all who are in a room.
   *
   * @param words what is said, one after the other; of a thing its label
   */
  record Say(Term who, List<Term> words) implements Body {
    public Say {
      words = List.copyOf(words);
    }
  }

  /**
   * A question to a person, or to all who are in a room; the first answer counts.
   *
   * @param words what is asked, one after the other; of a thing its label
   * @param answer stands for the answer in the parts; without a class for a text
   * @param format of the answer, where it is chosen instead of written; then there is no class
   */
  record Ask(
      Term who,
      List<Term> words,
      TypedVariable answer,
      Optional<AnswerFormat> format,
      List<Body> parts)
      implements Body {
    public Ask {
      words = List.copyOf(words);
      parts = List.copyOf(parts);
    }

    /** One that is answered in words. */
    public Ask(Term who, List<Term> words, TypedVariable answer, List<Body> parts) {
      this(who, words, answer, Optional.empty(), parts);
    }

    /** The same with other parts. */
    Ask with(List<Body> others) {
      return new Ask(who, words, answer, format, others);
    }

    /** The class or datatype of which the answer is to be. */
    public String type() {
      return answer.className().orElse("string");
    }
  }

  /** A message for another agent; what comes of it is that agent's matter. */
  record Tell(Term agent, Content message) implements Body {}

  /**
   * The script's agent shows a mood, until it shows another.
   *
   * @param word for it
   * @param intensity from 0 to 1
   */
  record Express(Term word, Term intensity) implements Body {}

  /** Somebody looks where the thing is, or how it is, whatever was known of that before. */
  record Look(Term thing) implements Body {}

  /** Facts that are so from now on, as the script says. */
  record Assert(Effect effect) implements Body {}

  /** Until the condition is known to hold. */
  record Await(Formula condition) implements Body {}

  /** For so many simulated seconds. */
  record Pause(Expression seconds) implements Body {}

  /** The script is over, and this is what it gives. */
  record Return(Term value) implements Body {}

  /** The script, or what is tried, has failed. */
  record Fail(String reason) implements Body {}

  /** What a variable can be given. */
  sealed interface Source {

    /** A number; it fails when that is not known. */
    record Value(Expression number) implements Source {}

    /**
     * The first individual of which the condition is known to hold; it fails when there is none.
     */
    record One(TypedVariable variable, Formula condition) implements Source {}
  }
}
