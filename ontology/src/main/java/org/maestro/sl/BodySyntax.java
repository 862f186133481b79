package org.maestro.sl;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Predicate;

/** Bodies of scripts. */
final class BodySyntax {
  private static final String A_STEP =
      "a step, such as (achieve (in Cup zone-a)) or (do move rose :to zone-a)";
  private static final String A_SOURCE =
      "what the variable stands for: (value (charge rose)), (one (?x - Thing) (in ?x zone-a)) or"
          + " (run script ...)";

  private static final String A_HOLD =
      "a member, its component in quotes, and steps, such as (hold rose \"base\" (wait 30))";

  private static final String A_SENTENCE =
      "a person or a room, and what is said, such as (say Bob \"The cup is in\" ?room)";
  private static final String A_QUESTION =
      "a person or a room, what is asked, a variable for the answer, and perhaps its class, such as"
          + " (ask Bob \"Which room?\" ?room Zone)";
  private static final String A_MESSAGE =
      "an agent and a message, such as (tell CCA (initCNP (:goal (in Cup zone-a))))";

  private final FormulaSyntax formulas;
  private final EffectSyntax effects;
  private final ContentSyntax contents;

  BodySyntax(Predicate<String> fluents) {
    this.formulas = new FormulaSyntax(fluents);
    this.effects = new EffectSyntax(fluents);
    this.contents = new ContentSyntax(fluents);
  }

  Body body(Node node) {
    if (!(node instanceof Node.Group group)) {
      throw node.fault(A_STEP);
    }
    List<Node> rest = group.children().isEmpty() ? List.of() : group.rest();
    return switch (group.head()) {
      case "seq" -> new Body.Seq(inTurn(group, rest));
      case "par" -> {
        expect(group, 1, Integer.MAX_VALUE, A_STEP);
        yield new Body.Par(rest.stream().map(this::body).toList());
      }
      case "if" -> {
        expect(group, 2, 3, "a condition, a step, and perhaps another");
        yield new Body.If(
            formulas.formula(rest.get(0)),
            body(rest.get(1)),
            rest.size() > 2 ? Optional.of(body(rest.get(2))) : Optional.empty());
      }
      case "while" -> repeated(group, rest);
      case "foreach" -> {
        expect(group, 3, 3, "a variable, a condition and a step");
        yield new Body.ForEach(
            variable(rest.get(0)), formulas.formula(rest.get(1)), body(rest.get(2)));
      }
      case "let" -> {
        expect(group, 2, Integer.MAX_VALUE, "a variable, what it stands for, and steps");
        yield new Body.Let(
            name(rest.get(0)), source(rest.get(1)), inTurn(group, rest.subList(2, rest.size())));
      }
      case "try" -> attempt(group, rest);
      case "achieve" -> {
        group.expectOperands(1, "a goal");
        yield new Body.Achieve(formulas.formula(rest.get(0)));
      }
      case "do" -> call(group, rest);
      case "hold" -> {
        expect(group, 3, Integer.MAX_VALUE, A_HOLD);
        yield hold(rest);
      }
      case "run" -> run(group, rest);
      case "say" -> {
        expect(group, 2, Integer.MAX_VALUE, A_SENTENCE);
        yield new Body.Say(
            ExpressionSyntax.term(rest.get(0)),
            ExpressionSyntax.terms(rest.subList(1, rest.size())));
      }
      case "ask" -> {
        expect(group, 3, Integer.MAX_VALUE, A_QUESTION);
        yield question(group, rest);
      }
      case "tell" -> {
        expect(group, 2, 2, A_MESSAGE);
        yield new Body.Tell(ExpressionSyntax.term(rest.get(0)), contents.content(rest.get(1)));
      }
      case "assert" -> {
        group.expectOperands(1, "an effect");
        yield new Body.Assert(effects.effect(rest.get(0)));
      }
      case "wait" -> {
        group.expectOperands(1, "a condition or seconds");
        yield isNumber(rest.get(0))
            ? new Body.Pause(ExpressionSyntax.expression(rest.get(0)))
            : new Body.Await(formulas.formula(rest.get(0)));
      }
      case "express" -> {
        expect(group, 2, 2, "a word and a number from 0 to 1, such as (express glad 0.8)");
        yield new Body.Express(
            ExpressionSyntax.term(rest.get(0)), ExpressionSyntax.term(rest.get(1)));
      }
      case "look" -> {
        group.expectOperands(1, "a thing");
        yield new Body.Look(ExpressionSyntax.term(rest.get(0)));
      }
      case "return" -> {
        group.expectOperands(1, "a term");
        yield new Body.Return(ExpressionSyntax.term(rest.get(0)));
      }
      case "fail" -> {
        group.expectOperands(1, "a reason in quotes");
        yield new Body.Fail(text(rest.get(0)));
      }
      default -> throw node.fault(A_STEP);
    };
  }

  private List<Body> inTurn(Node.Group group, List<Node> nodes) {
    if (nodes.isEmpty()) {
      throw new SlSyntaxException(group.end(), A_STEP, "\")\"");
    }
    return inTurn(nodes);
  }

  /** What comes after a question without steps of its own are its steps: they know the answer. */
  private List<Body> inTurn(List<Node> nodes) {
    Deque<Body> steps = new ArrayDeque<>();
    for (int at = nodes.size() - 1; at >= 0; at--) {
      Body step = body(nodes.get(at));
      if (step instanceof Body.Ask ask && ask.parts().isEmpty() && !steps.isEmpty()) {
        Body whole = ask.with(List.copyOf(steps));
        steps.clear();
        steps.push(whole);
      } else {
        steps.push(step);
      }
    }
    return List.copyOf(steps);
  }

  private Body question(Node.Group group, List<Node> rest) {
    int end = 0;
    while (end < rest.size() && rest.get(end) instanceof Node.Leaf) {
      end++;
    }
    boolean isTyped = end > 1 && isOf(Node.Kind.WORD, rest.get(end - 1));
    int variable = isTyped ? end - 2 : end - 1;
    if (variable < 2 || !isOf(Node.Kind.VARIABLE, rest.get(variable))) {
      throw end < rest.size()
          ? rest.get(end).fault(A_QUESTION)
          : new SlSyntaxException(group.end(), A_QUESTION, "\")\"");
    }
    Optional<String> type =
        isTyped
            ? Optional.of(ExpressionSyntax.name(rest.get(end - 1), "a class"))
            : Optional.empty();
    Optional<AnswerFormat> format =
        isTyped || end == rest.size()
            ? Optional.empty()
            : AnswerFormatSyntax.format((Node.Group) rest.get(end));
    return new Body.Ask(
        ExpressionSyntax.term(rest.get(0)),
        ExpressionSyntax.terms(rest.subList(1, variable)),
        new TypedVariable(name(rest.get(variable)), type),
        format,
        inTurn(rest.subList(format.isPresent() ? end + 1 : end, rest.size())));
  }

  private static boolean isOf(Node.Kind kind, Node node) {
    return node instanceof Node.Leaf leaf && leaf.kind() == kind;
  }

  private Body repeated(Node.Group group, List<Node> rest) {
    expect(group, 2, 4, "a condition and a step");
    OptionalInt most = OptionalInt.empty();
    if (rest.size() > 2) {
      expect(group, 4, 4, ":most and a number");
      if (!isKeyword(rest.get(2), "most")) {
        throw rest.get(2).fault(":most");
      }
      most = OptionalInt.of(count(rest.get(3)));
    }
    return new Body.While(formulas.formula(rest.get(0)), round(rest.get(1)), most);
  }

  /** Only as long as a condition holds something may be held for its own sake. */
  private Body round(Node node) {
    return node instanceof Node.Group group
            && group.head().equals("hold")
            && group.rest().size() == 2
        ? hold(group.rest())
        : body(node);
  }

  private static int count(Node node) {
    if (node instanceof Node.Leaf leaf
        && leaf.kind() == Node.Kind.NUMBER
        && leaf.text().matches("[1-9][0-9]{0,8}")) {
      return Integer.parseInt(leaf.text());
    }
    throw node.fault("a whole number above 0");
  }

  private Body attempt(Node.Group group, List<Node> rest) {
    expect(group, 2, Integer.MAX_VALUE, "a step, and (recover ...) or (finally ...)");
    List<Body.Recovery> recoveries = new ArrayList<>();
    Optional<Body> last = Optional.empty();
    for (Node node : rest.subList(1, rest.size())) {
      if (!(node instanceof Node.Group clause) || last.isPresent()) {
        throw node.fault("\")\"");
      }
      if (clause.head().equals("recover")) {
        recoveries.add(recovery(clause));
      } else if (clause.head().equals("finally")) {
        clause.expectOperands(1, A_STEP);
        last = Optional.of(body(clause.rest().get(0)));
      } else {
        throw node.fault("(recover ...) or (finally ...)");
      }
    }
    return new Body.Try(body(rest.get(0)), recoveries, last);
  }

  private Body.Recovery recovery(Node.Group clause) {
    expect(clause, 1, 2, "a step, before it perhaps a reason in quotes");
    List<Node> rest = clause.rest();
    return rest.size() == 1
        ? new Body.Recovery(Optional.empty(), body(rest.get(0)))
        : new Body.Recovery(Optional.of(text(rest.get(0))), body(rest.get(1)));
  }

  private static Body call(Node.Group group, List<Node> rest) {
    expect(group, 2, Integer.MAX_VALUE, "a feature and a member");
    String feature = ExpressionSyntax.name(rest.get(0), "the name of a feature");
    Map<String, Term> parameters = new LinkedHashMap<>();
    for (int at = 2; at < rest.size(); at += 2) {
      if (!(rest.get(at) instanceof Node.Leaf leaf) || leaf.kind() != Node.Kind.KEYWORD) {
        throw rest.get(at).fault("the name of a parameter, such as :to");
      }
      if (at + 1 == rest.size()) {
        throw new SlSyntaxException(group.end(), "a term for :" + leaf.text(), "\")\"");
      }
      if (parameters.put(leaf.text(), ExpressionSyntax.term(rest.get(at + 1))) != null) {
        throw leaf.fault("each parameter once");
      }
    }
    return new Body.Do(feature, ExpressionSyntax.term(rest.get(1)), parameters);
  }

  private Body hold(List<Node> rest) {
    return new Body.Hold(
        ExpressionSyntax.term(rest.get(0)),
        text(rest.get(1)),
        inTurn(rest.subList(2, rest.size())));
  }

  private static Body.Run run(Node.Group group, List<Node> rest) {
    expect(group, 1, Integer.MAX_VALUE, "the name of a script");
    return new Body.Run(
        ExpressionSyntax.name(rest.get(0), "the name of a script"),
        ExpressionSyntax.terms(rest.subList(1, rest.size())));
  }

  private Body.Source source(Node node) {
    if (!(node instanceof Node.Group group) || group.children().isEmpty()) {
      throw node.fault(A_SOURCE);
    }
    return switch (group.head()) {
      case "value" -> {
        group.expectOperands(1, "a number or a fluent");
        yield new Body.Source.Value(ExpressionSyntax.expression(group.rest().get(0)));
      }
      case "one" -> {
        group.expectOperands(2, "a variable and a condition");
        yield new Body.Source.One(
            variable(group.rest().get(0)), formulas.formula(group.rest().get(1)));
      }
      case "run" -> run(group, group.rest());
      default -> throw node.fault(A_SOURCE);
    };
  }

  private static TypedVariable variable(Node node) {
    List<TypedVariable> variables = ExpressionSyntax.variables(node);
    if (variables.size() > 1) {
      throw node.fault("one variable in parentheses, such as (?x - Thing)");
    }
    return variables.get(0);
  }

  private static String name(Node node) {
    if (node instanceof Node.Leaf leaf && leaf.kind() == Node.Kind.VARIABLE) {
      return leaf.text();
    }
    throw node.fault("a variable such as ?x");
  }

  private static String text(Node node) {
    if (node instanceof Node.Leaf leaf && leaf.kind() == Node.Kind.STRING) {
      return leaf.text();
    }
    throw node.fault("a text in quotes");
  }

  private static boolean isKeyword(Node node, String name) {
    return node instanceof Node.Leaf leaf
        && leaf.kind() == Node.Kind.KEYWORD
        && leaf.text().equals(name);
  }

  /** Seconds are a number or a variable; what is in parentheses is a condition. */
  private static boolean isNumber(Node node) {
    return node instanceof Node.Leaf;
  }

  private static void expect(Node.Group group, int least, int most, String expected) {
    int operands = group.rest().size();
    if (operands < least) {
      throw new SlSyntaxException(group.end(), expected, "\")\"");
    }
    if (operands > most) {
      throw group.rest().get(most).fault("\")\"");
    }
  }
}
