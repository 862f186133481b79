package org.maestro.sl;

import java.util.List;
import java.util.Optional;

/** Response formats of questions. */
final class AnswerFormatSyntax {
  private static final String CHOICE = "choice";
  private static final String SLIDER = "slider";
  private static final String OPTIONS =
      "answers of which one is chosen, such as (choice \"good\" \"fair\" \"bad\")";
  private static final String RANGE =
      "the lowest number, the highest, the step, and perhaps what stands at both ends, such as"
          + " (slider 1 7 1 \"not at all\" \"very\")";

  private static final int LIMITS = 3;
  private static final int WITH_LABELS = 5;

  private AnswerFormatSyntax() {}

  /** Empty: the group is no format. */
  static Optional<AnswerFormat> format(Node.Group group) {
    if (group.children().isEmpty()) {
      return Optional.empty();
    }
    return switch (group.head()) {
      case CHOICE -> Optional.of(choice(group));
      case SLIDER -> Optional.of(slider(group));
      default -> Optional.empty();
    };
  }

  private static AnswerFormat choice(Node.Group group) {
    if (group.rest().isEmpty()) {
      throw new SlSyntaxException(group.end(), OPTIONS, "\")\"");
    }
    return new AnswerFormat.Choice(ExpressionSyntax.terms(group.rest()));
  }

  private static AnswerFormat slider(Node.Group group) {
    List<Node> rest = group.rest();
    if (rest.size() > WITH_LABELS) {
      throw rest.get(WITH_LABELS).fault("\")\"");
    }
    if (rest.size() != LIMITS && rest.size() != WITH_LABELS) {
      throw new SlSyntaxException(group.end(), RANGE, "\")\"");
    }
    boolean isLabelled = rest.size() == WITH_LABELS;
    return new AnswerFormat.Slider(
        number(rest.get(0)),
        number(rest.get(1)),
        number(rest.get(2)),
        isLabelled ? text(rest.get(LIMITS)) : "",
        isLabelled ? text(rest.get(LIMITS + 1)) : "");
  }

  private static double number(Node node) {
    if (node instanceof Node.Leaf leaf
        && leaf.kind() == Node.Kind.NUMBER
        && ExpressionSyntax.term(node) instanceof Term.Number number) {
      return number.value();
    }
    throw node.fault(RANGE);
  }

  private static String text(Node node) {
    if (node instanceof Node.Leaf leaf && leaf.kind() == Node.Kind.STRING) {
      return leaf.text();
    }
    throw node.fault(RANGE);
  }
}
