package org.maestro.sl;

import java.util.List;

/** A node of the reader's syntax tree: nested lists of tokens, each with its column. */
sealed interface Node {

  int column();

  /** How it looks in an error message. */
  String shown();

  default SlSyntaxException fault(String expected) {
    return new SlSyntaxException(column(), expected, shown());
  }

  /** A token; {@code text} is without quotes, brackets, question mark or colon. */
  record Leaf(Kind kind, String text, int column) implements Node {
    @Override
    public String shown() {
      return switch (kind) {
        case VARIABLE -> "\"?" + text + "\"";
        case KEYWORD -> "\":" + text + "\"";
        case IRI -> "\"<" + text + ">\"";
        case STRING -> "the string \"" + text + "\"";
        case NUMBER, WORD -> "\"" + text + "\"";
      };
    }
  }

  /** A list; {@code end} is the column of its closing parenthesis. */
  record Group(List<Node> children, int column, int end) implements Node {
    @Override
    public String shown() {
      if (children.isEmpty()) {
        return "\"()\"";
      }
      return children.get(0) instanceof Leaf leaf
          ? "\"(" + leaf.shown().replace("\"", "") + " ...)\""
          : "\"((...\"";
    }

    /** The word it begins with, or "" when it begins otherwise. */
    String head() {
      return !children.isEmpty() && children.get(0) instanceof Leaf leaf && leaf.kind() == Kind.WORD
          ? leaf.text()
          : "";
    }

    List<Node> rest() {
      return children.subList(1, children.size());
    }

    /**
     * Refuses a list with another number of operands, at the column where one is missing or too
     * many.
     */
    void expectOperands(int count, String expected) {
      if (rest().size() < count) {
        throw new SlSyntaxException(end, expected, "\")\"");
      }
      if (rest().size() > count) {
        throw rest().get(count).fault("\")\"");
      }
    }
  }

  enum Kind {
    WORD,
    NUMBER,
    VARIABLE,
    KEYWORD,
    STRING,
    IRI
  }
}
