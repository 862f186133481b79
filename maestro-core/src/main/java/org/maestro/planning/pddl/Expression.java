package org.maestro.planning.pddl;

import java.util.List;
import java.util.stream.Collectors;

/** A word or a list in parentheses, and where it stands. */
sealed interface Expression {
  Position position();

  /** Its words in the order in which they stand. */
  String text();

  /** Line and column are counted from 1. */
  record Position(String source, int line, int column) {
    PddlException error(String problem) {
      return new PddlException(source, line, column, problem);
    }

    @Override
    public String toString() {
      return source + ":" + line + ":" + column;
    }
  }

  /** PDDL knows no case: the text is in small letters. */
  record Word(Position position, String text) implements Expression {
    boolean isVariable() {
      return text.startsWith("?");
    }
  }

  record Group(Position position, List<Expression> items) implements Expression {
    @Override
    public String text() {
      return items.stream().map(Expression::text).collect(Collectors.joining(" ", "(", ")"));
    }

    /** The first word, by which lists are told apart; empty when there is none. */
    String head() {
      return !items.isEmpty() && items.get(0) instanceof Word word ? word.text() : "";
    }

    List<Expression> rest() {
      return items.subList(1, items.size());
    }
  }

  default Word word(String expected) {
    if (this instanceof Word word) {
      return word;
    }
    throw position().error("Expected %s, found a list.".formatted(expected));
  }

  default Group group(String expected) {
    if (this instanceof Group group) {
      return group;
    }
    throw position().error("Expected %s, found %s.".formatted(expected, ((Word) this).text()));
  }
}
