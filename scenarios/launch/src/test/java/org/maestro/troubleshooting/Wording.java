package org.maestro.troubleshooting;

import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.ParenthesizedTree;
import com.sun.source.tree.Tree;
import java.util.Optional;
import java.util.regex.Pattern;

/** The words of an expression in a source, with an ellipsis for all that is filled in. */
final class Wording {
  private static final Pattern FILLED_IN =
      Pattern.compile("%(\\d+\\$)?[-0-9.,]*[a-zA-MO-Z]|\\{}|…");

  /** What is longer is a file that is written. */
  private static final int LONGEST = 400;

  private static final Pattern WORD = Pattern.compile("\\p{L}{2,}");

  private Wording() {}

  /** What the expression says; nothing when no word of it stands in the source. */
  static Optional<String> of(ExpressionTree expression) {
    return raw(expression).map(Wording::cleaned).filter(Wording::says);
  }

  /** The text of what is put together of literals and others; nothing when there is no literal. */
  private static Optional<String> raw(ExpressionTree expression) {
    if (expression instanceof ParenthesizedTree parenthesized) {
      return raw(parenthesized.getExpression());
    }
    if (expression instanceof LiteralTree literal) {
      return literal.getValue() instanceof String text ? Optional.of(text) : Optional.empty();
    }
    if (expression instanceof BinaryTree sum && sum.getKind() == Tree.Kind.PLUS) {
      Optional<String> left = raw(sum.getLeftOperand());
      Optional<String> right = raw(sum.getRightOperand());
      return left.isEmpty() && right.isEmpty()
          ? Optional.empty()
          : Optional.of(left.orElse(Message.ANYTHING) + right.orElse(Message.ANYTHING));
    }
    return Optional.empty();
  }

  static String cleaned(String text) {
    return FILLED_IN
        .matcher(text)
        .replaceAll(Message.ANYTHING)
        .replace("%%", "%")
        .replace("%n", " ")
        .replaceAll("\\s+", " ")
        .replaceAll("…(…)+", Message.ANYTHING)
        .strip();
  }

  /** Three words at least, what is filled in among them: fewer are a name, a key, or too little. */
  static boolean says(String text) {
    return !text.startsWith("(")
        && text.split(" ").length >= 3
        && WORD.matcher(text).results().count() >= 2;
  }

  /** Whether it can stand by itself: with a full stop, or with its cure behind a semicolon. */
  static boolean isSentence(String text) {
    return text.matches("[\\p{Lu}…\"].*")
        && (text.endsWith(".") || text.contains("; "))
        && text.length() < LONGEST
        && text.split(" ").length >= 5;
  }
}
