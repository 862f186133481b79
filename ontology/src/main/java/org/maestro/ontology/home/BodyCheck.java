package org.maestro.ontology.home;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.vocabulary.NameCheck;
import org.maestro.sl.AnswerFormat;
import org.maestro.sl.Body;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * Checks the steps of a script: that each speaks of what there is in the home, as it is, and of
 * variables that are bound where it stands.
 */
final class BodyCheck {
  private static final List<String> A_NUMBER = List.of("decimal");

  private final Home home;
  private final CallCheck calls;
  private final HoldCheck holds;
  private final SpeechCheck speech;
  private final TermFit fit;
  private final BiConsumer<String, String> problems;

  /**
   * @param problems takes a problem and its cure
   */
  BodyCheck(Home home, Offers offers, BiConsumer<String, String> problems) {
    this.home = home;
    this.calls = new CallCheck(home, offers, problems);
    this.holds = new HoldCheck(home, offers, problems);
    this.speech = new SpeechCheck(home, problems);
    this.fit = new TermFit(home);
    this.problems = problems;
  }

  /**
   * @param variables those that are bound there, with the classes and datatypes of which each may
   *     be; none where that is not known
   */
  void check(Body body, Map<String, List<String>> variables) {
    if (body instanceof Body.ForEach each) {
      range(each.variable(), each.condition(), variables);
      check(each.body(), with(variables, each.variable().name(), classes(each.variable())));
    } else if (body instanceof Body.Let let) {
      Map<String, List<String>> inside =
          with(variables, let.variable(), source(let.source(), variables));
      let.parts().forEach(part -> check(part, inside));
    } else if (body instanceof Body.Ask ask) {
      names(variables).check(ask.who());
      ask.words().forEach(names(variables)::check);
      ask.format().ifPresent(format -> options(format).forEach(names(variables)::check));
      speech.check(ask, variables);
      Map<String, List<String>> inside = with(variables, ask.answer().name(), types(ask));
      ask.parts().forEach(part -> check(part, inside));
    } else {
      step(body, variables);
      body.parts().forEach(part -> check(part, variables));
    }
  }

  private static List<Term> options(AnswerFormat format) {
    return format instanceof AnswerFormat.Choice choice ? choice.options() : List.of();
  }

  private static List<String> types(Body.Ask ask) {
    return ask.format()
        .map(AnswerFormatCheck::types)
        .orElseGet(() -> List.of(SpeechCheck.answer(ask)));
  }

  private void step(Body body, Map<String, List<String>> variables) {
    NameCheck names = names(variables);
    if (body instanceof Body.If choice) {
      names.check(choice.condition());
    } else if (body instanceof Body.While loop) {
      names.check(loop.condition());
    } else if (body instanceof Body.Achieve achieve) {
      names.check(achieve.goal());
    } else if (body instanceof Body.Await await) {
      names.check(await.condition());
    } else if (body instanceof Body.Pause pause) {
      names.check(pause.seconds());
    } else if (body instanceof Body.Assert stated) {
      names.check(stated.effect());
      if (isSensing(stated.effect())) {
        problems.accept(
            "asserts what is to be sensed", "assert a fact, or have a device look with do");
      }
    } else if (body instanceof Body.Return back) {
      names.check(back.value());
    } else if (body instanceof Body.Run run) {
      check(run, variables);
    } else if (body instanceof Body.Hold hold) {
      names.check(hold.member());
      holds.check(hold, variables);
    } else if (body instanceof Body.Say say) {
      names.check(say.who());
      say.words().forEach(names::check);
      speech.hears(say.who(), variables);
    } else if (body instanceof Body.Tell tell) {
      if (tell.agent() instanceof Term.Variable) {
        names.check(tell.agent());
      }
      speech.check(tell, variables);
    } else if (body instanceof Body.Express express) {
      names.check(express.intensity());
      if (express.word() instanceof Term.Variable) {
        names.check(express.word());
      }
      speech.check(express, variables);
    } else if (body instanceof Body.Look look) {
      names.check(look.thing());
      speech.check(look, variables);
    } else if (body instanceof Body.Do call) {
      names.check(call.member());
      call.parameters().values().forEach(names::check);
      calls.check(call, variables);
    }
  }

  /** A script senses nothing by itself. */
  private static boolean isSensing(Effect effect) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().anyMatch(BodyCheck::isSensing);
    } else if (effect instanceof Effect.When when) {
      return isSensing(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      return isSensing(forall.effect());
    }
    return effect instanceof Effect.SenseAtom || effect instanceof Effect.SenseNumber;
  }

  /** What is told of the names in a formula, an effect, a number or a term. */
  NameCheck names(Map<String, List<String>> variables) {
    return new NameCheck(
        home.vocabulary(),
        home.individuals()::containsKey,
        (name, type) -> HomeCheck.named(home.individuals(), name).classes().contains(type),
        variables,
        (kind, word) ->
            kind.equals("Individual")
                ? Nearest.cure(word, home.individuals().keySet(), NameCheck.declare(kind, word))
                : NameCheck.declare(kind, word),
        problems);
  }

  /** The classes of which what the source gives may be. */
  private List<String> source(Body.Source source, Map<String, List<String>> variables) {
    if (source instanceof Body.Source.Value value) {
      names(variables).check(value.number());
      return A_NUMBER;
    } else if (source instanceof Body.Source.One one) {
      range(one.variable(), one.condition(), variables);
      return classes(one.variable());
    }
    check((Body.Run) source, variables);
    return List.of();
  }

  private void range(
      TypedVariable variable, Formula condition, Map<String, List<String>> variables) {
    if (variable.className().isEmpty()) {
      problems.accept(
          "goes through everything for ?" + variable.name(),
          "give it a class, such as (?%s - Thing)".formatted(variable.name()));
    }
    names(variables).check(new Formula.Exists(List.of(variable), condition));
  }

  private void check(Body.Run run, Map<String, List<String>> variables) {
    run.arguments().forEach(names(variables)::check);
    Script script = home.scripts().get(run.script());
    if (script == null) {
      problems.accept(
          "runs the unknown script " + run.script(),
          Nearest.cure(run.script(), home.scripts().keySet(), "describe it as a maestro:Script"));
    } else if (script.parameters().size() != run.arguments().size()) {
      problems.accept(
          "gives %s %d arguments".formatted(script.name(), run.arguments().size()),
          "write " + form(script));
    } else {
      for (int i = 0; i < run.arguments().size(); i++) {
        check(script, script.parameters().get(i), run.arguments().get(i), variables);
      }
    }
  }

  private void check(
      Script script, TypedVariable parameter, Term given, Map<String, List<String>> variables) {
    if (!fit.fits(given, classes(parameter), variables)) {
      problems.accept(
          "gives %s for ?%s of %s, which cannot be that"
              .formatted(SlPrinter.print(given), parameter.name(), script.name()),
          "write " + form(script));
    }
  }

  private static String form(Script script) {
    return script.parameters().stream()
        .map(parameter -> " " + SlPrinter.print(parameter))
        .collect(Collectors.joining("", "(run " + script.name(), ")"));
  }

  static List<String> classes(TypedVariable variable) {
    return variable.className().map(List::of).orElse(List.of());
  }

  private static Map<String, List<String>> with(
      Map<String, List<String>> variables, String name, List<String> classes) {
    Map<String, List<String>> more = new HashMap<>(variables);
    more.put(name, classes);
    return more;
  }
}
