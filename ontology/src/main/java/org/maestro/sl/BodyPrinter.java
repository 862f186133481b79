package org.maestro.sl;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Prints bodies of scripts; the inverse of {@link BodySyntax}. */
final class BodyPrinter {
  private static final String LEFT_OUT = "…";

  private BodyPrinter() {}

  static String print(Body body) {
    if (body instanceof Body.Seq seq) {
      return group("seq", inTurn(seq.parts()));
    } else if (body instanceof Body.Par par) {
      return group("par", printed(par.parts()));
    } else if (body instanceof Body.If choice) {
      List<String> parts = parts(SlPrinter.print(choice.condition()), print(choice.then()));
      choice.otherwise().ifPresent(other -> parts.add(print(other)));
      return group("if", parts);
    } else if (body instanceof Body.While loop) {
      List<String> parts = parts(SlPrinter.print(loop.condition()), print(loop.body()));
      loop.most().ifPresent(most -> parts.add(":most " + most));
      return group("while", parts);
    } else if (body instanceof Body.ForEach each) {
      return group(
          "foreach",
          parts(variable(each.variable()), SlPrinter.print(each.condition()), print(each.body())));
    } else if (body instanceof Body.Let let) {
      List<String> parts = parts("?" + let.variable(), print(let.source()));
      parts.addAll(inTurn(let.parts()));
      return group("let", parts);
    } else if (body instanceof Body.Try attempt) {
      List<String> parts = parts(print(attempt.body()));
      attempt.recoveries().forEach(recovery -> parts.add(print(recovery)));
      attempt.last().ifPresent(last -> parts.add(group("finally", parts(print(last)))));
      return group("try", parts);
    } else if (body instanceof Body.Do call) {
      List<String> parts = parts(call.feature(), SlPrinter.print(call.member()));
      new TreeMap<>(call.parameters())
          .forEach((name, term) -> parts.add(":" + name + " " + SlPrinter.print(term)));
      return group("do", parts);
    } else if (body instanceof Body.Hold hold) {
      List<String> parts = parts(SlPrinter.print(hold.member()), component(hold));
      parts.addAll(inTurn(hold.parts()));
      return group("hold", parts);
    } else if (body instanceof Body.Say say) {
      List<String> parts = parts(SlPrinter.print(say.who()));
      say.words().forEach(word -> parts.add(SlPrinter.print(word)));
      return group("say", parts);
    } else if (body instanceof Body.Ask ask) {
      List<String> parts = question(ask);
      parts.addAll(inTurn(ask.parts()));
      return group("ask", parts);
    } else if (body instanceof Body.Run run) {
      return print((Body.Source) run);
    }
    return single(body);
  }

  /** The step by itself: what is in it is left out. */
  static String head(Body body) {
    if (body instanceof Body.Seq) {
      return "(seq …)";
    } else if (body instanceof Body.Par) {
      return "(par …)";
    } else if (body instanceof Body.If choice) {
      return group("if", parts(SlPrinter.print(choice.condition()), LEFT_OUT));
    } else if (body instanceof Body.While loop) {
      List<String> parts = parts(SlPrinter.print(loop.condition()), LEFT_OUT);
      loop.most().ifPresent(most -> parts.add(":most " + most));
      return group("while", parts);
    } else if (body instanceof Body.ForEach each) {
      return group(
          "foreach", parts(variable(each.variable()), SlPrinter.print(each.condition()), LEFT_OUT));
    } else if (body instanceof Body.Let let) {
      return group("let", parts("?" + let.variable(), print(let.source()), LEFT_OUT));
    } else if (body instanceof Body.Try) {
      return "(try …)";
    } else if (body instanceof Body.Hold hold) {
      return group("hold", parts(SlPrinter.print(hold.member()), component(hold), LEFT_OUT));
    }
    return body instanceof Body.Ask ask ? group("ask", question(ask)) : print(body);
  }

  private static String component(Body.Hold hold) {
    return SlPrinter.print(new Term.Text(hold.component()));
  }

  private static String single(Body body) {
    if (body instanceof Body.Achieve achieve) {
      return group("achieve", parts(SlPrinter.print(achieve.goal())));
    } else if (body instanceof Body.Tell tell) {
      return group("tell", parts(SlPrinter.print(tell.agent()), SlPrinter.print(tell.message())));
    } else if (body instanceof Body.Assert stated) {
      return group("assert", parts(SlPrinter.print(stated.effect())));
    } else if (body instanceof Body.Await await) {
      return group("wait", parts(SlPrinter.print(await.condition())));
    } else if (body instanceof Body.Pause pause) {
      return group("wait", parts(SlPrinter.print(pause.seconds())));
    } else if (body instanceof Body.Look look) {
      return group("look", parts(SlPrinter.print(look.thing())));
    } else if (body instanceof Body.Express express) {
      return group(
          "express", parts(SlPrinter.print(express.word()), SlPrinter.print(express.intensity())));
    } else if (body instanceof Body.Return back) {
      return group("return", parts(SlPrinter.print(back.value())));
    }
    return group("fail", parts(SlPrinter.print(new Term.Text(((Body.Fail) body).reason()))));
  }

  private static String print(Body.Recovery recovery) {
    List<String> parts = new ArrayList<>();
    recovery.reason().ifPresent(reason -> parts.add(SlPrinter.print(new Term.Text(reason))));
    parts.add(print(recovery.body()));
    return group("recover", parts);
  }

  private static String print(Body.Source source) {
    if (source instanceof Body.Source.Value value) {
      return group("value", parts(SlPrinter.print(value.number())));
    } else if (source instanceof Body.Source.One one) {
      return group("one", parts(variable(one.variable()), SlPrinter.print(one.condition())));
    }
    Body.Run run = (Body.Run) source;
    List<String> parts = parts(run.script());
    run.arguments().forEach(term -> parts.add(SlPrinter.print(term)));
    return group("run", parts);
  }

  private static String variable(TypedVariable variable) {
    return "(" + SlPrinter.print(variable) + ")";
  }

  private static List<String> question(Body.Ask ask) {
    List<String> parts = parts(SlPrinter.print(ask.who()));
    ask.words().forEach(word -> parts.add(SlPrinter.print(word)));
    parts.add("?" + ask.answer().name());
    ask.answer().className().ifPresent(parts::add);
    ask.format().ifPresent(format -> parts.add(print(format)));
    return parts;
  }

  private static String print(AnswerFormat format) {
    List<String> parts = new ArrayList<>();
    if (format instanceof AnswerFormat.Choice choice) {
      parts.add("choice");
      choice.options().forEach(option -> parts.add(SlPrinter.print(option)));
    } else {
      AnswerFormat.Slider slider = (AnswerFormat.Slider) format;
      parts.add("slider");
      parts.add(SlPrinter.print(slider.lowest()));
      parts.add(SlPrinter.print(slider.highest()));
      parts.add(SlPrinter.print(slider.step()));
      if (!slider.lowestLabel().isEmpty() || !slider.highestLabel().isEmpty()) {
        parts.add(SlPrinter.print(new Term.Text(slider.lowestLabel())));
        parts.add(SlPrinter.print(new Term.Text(slider.highestLabel())));
      }
    }
    return "(" + String.join(" ", parts) + ")";
  }

  /** The steps of a question that is the last of several are written after it. */
  private static List<String> inTurn(List<Body> bodies) {
    List<String> printed = new ArrayList<>();
    List<Body> left = bodies;
    while (!left.isEmpty()) {
      int last = left.size() - 1;
      printed.addAll(printed(left.subList(0, last)));
      if (left.get(last) instanceof Body.Ask ask) {
        printed.add(group("ask", question(ask)));
        left = ask.parts();
      } else {
        printed.add(print(left.get(last)));
        left = List.of();
      }
    }
    return printed;
  }

  private static List<String> printed(List<Body> bodies) {
    return bodies.stream().map(BodyPrinter::print).toList();
  }

  private static List<String> parts(String... parts) {
    return new ArrayList<>(List.of(parts));
  }

  private static String group(String head, List<String> parts) {
    return parts.stream().collect(Collectors.joining(" ", "(" + head + " ", ")"));
  }
}
