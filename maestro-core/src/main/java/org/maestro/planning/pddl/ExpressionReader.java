package org.maestro.planning.pddl;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import org.maestro.planning.pddl.Expression.Group;
import org.maestro.planning.pddl.Expression.Position;
import org.maestro.planning.pddl.Expression.Word;

/** Splits a text into lists and words. */
final class ExpressionReader {
  private static final int MOST_NESTED = 1000;

  private final String source;
  private final String text;
  private int at;
  private int line = 1;
  private int lineStart;

  private ExpressionReader(String source, String text) {
    this.source = source;
    this.text = text;
  }

  /** The text's only list. */
  static Group read(String source, String text) {
    // Some editors begin a text with a mark of its byte order.
    String plain = text.startsWith("\uFEFF") ? text.substring(1) : text;
    ExpressionReader reader = new ExpressionReader(source, plain);
    Group result = reader.readAll();
    reader.skip();
    if (reader.at < plain.length()) {
      throw reader.here().error("Expected the end of the text, found more after its only list.");
    }
    return result;
  }

  private Group readAll() {
    skip();
    if (at == text.length() || text.charAt(at) != '(') {
      throw here().error("Expected '(define', found no list.");
    }
    Deque<Group> open = new ArrayDeque<>();
    while (true) {
      skip();
      if (at == text.length()) {
        throw open.getLast().position().error("This '(' is never closed.");
      }
      char next = text.charAt(at);
      if (next == '(') {
        if (open.size() == MOST_NESTED) {
          throw here().error("Lists are more than %d deep in each other.".formatted(MOST_NESTED));
        }
        open.addLast(new Group(here(), new ArrayList<>()));
        at++;
      } else if (next == ')') {
        at++;
        Group closed = open.removeLast();
        Group done = new Group(closed.position(), List.copyOf(closed.items()));
        if (open.isEmpty()) {
          return done;
        }
        open.getLast().items().add(done);
      } else {
        open.getLast().items().add(word());
      }
    }
  }

  private Word word() {
    Position position = here();
    int from = at++;
    while (at < text.length() && !isBorder(text.charAt(at))) {
      at++;
    }
    return new Word(position, text.substring(from, at).toLowerCase(Locale.ROOT));
  }

  /** A variable begins a word of its own, also without a blank before it. */
  private static boolean isBorder(char c) {
    return c == '(' || c == ')' || c == ';' || c == '?' || Character.isWhitespace(c);
  }

  private void skip() {
    while (at < text.length()) {
      char c = text.charAt(at);
      if (c == ';') {
        while (at < text.length() && text.charAt(at) != '\n') {
          at++;
        }
      } else if (c == '\n') {
        at++;
        line++;
        lineStart = at;
      } else if (Character.isWhitespace(c)) {
        at++;
      } else {
        return;
      }
    }
  }

  private Position here() {
    return new Position(source, line, at - lineStart + 1);
  }
}
