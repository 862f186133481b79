package org.maestro.sl;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Reads a text into nested lists of tokens. */
final class SlReader {

  static final int MAXIMUM_DEPTH = 100;

  private static final Set<String> SYMBOLS = Set.of("=", "<", "<=", ">", ">=", "+", "-", "*", "/");

  private final String text;
  private int at;

  private SlReader(String text) {
    this.text = text;
  }

  /** The one expression of the text. */
  static Node readOne(String text, String expected) {
    SlReader reader = new SlReader(text);
    Node node = reader.next(expected, 0);
    reader.skipSpace();
    if (reader.at < text.length()) {
      if (node instanceof Node.Leaf leaf && leaf.kind() == Node.Kind.WORD) {
        throw node.fault("\"(\", as in (%s),".formatted(text.strip()));
      }
      throw new SlSyntaxException(
          reader.at + 1, "the end of the text", reader.quoted(reader.at, reader.at + 1));
    }
    return node;
  }

  /** All expressions of the text. */
  static List<Node> readAll(String text, String expected) {
    SlReader reader = new SlReader(text);
    List<Node> nodes = new ArrayList<>();
    do {
      nodes.add(reader.next(expected, 0));
      reader.skipSpace();
    } while (reader.at < text.length());
    return nodes;
  }

  private Node next(String expected, int depth) {
    skipSpace();
    int start = at;
    if (at == text.length()) {
      throw new SlSyntaxException(start + 1, expected, "the end of the text");
    }
    return switch (text.charAt(at)) {
      case '(' -> group(depth);
      case ')' -> throw new SlSyntaxException(start + 1, expected, "\")\"");
      case '"' -> string();
      case '<' -> startsIri() ? iri() : word();
      default -> word();
    };
  }

  private Node group(int depth) {
    int start = at++;
    if (depth == MAXIMUM_DEPTH) {
      throw new SlSyntaxException(
          start + 1, "a nesting of at most " + MAXIMUM_DEPTH + " parentheses", "one more");
    }
    List<Node> children = new ArrayList<>();
    skipSpace();
    while (at < text.length() && text.charAt(at) != ')') {
      children.add(next("\")\"", depth + 1));
      skipSpace();
    }
    if (at == text.length()) {
      throw new SlSyntaxException(
          at + 1, "the \")\" for the \"(\" at column " + (start + 1), "the end of the text");
    }
    at++;
    return new Node.Group(List.copyOf(children), start + 1, at);
  }

  private Node string() {
    int start = at++;
    StringBuilder value = new StringBuilder();
    while (at < text.length() && text.charAt(at) != '"') {
      if (text.charAt(at) == '\\') {
        at++;
        if (at == text.length() || "\"\\".indexOf(text.charAt(at)) < 0) {
          throw new SlSyntaxException(at, "\\\" or \\\\", quoted(at - 1, at + 1));
        }
      }
      value.append(text.charAt(at++));
    }
    if (at == text.length()) {
      throw new SlSyntaxException(
          at + 1, "the '\"' that ends the string of column " + (start + 1), "the end of the text");
    }
    at++;
    return new Node.Leaf(Node.Kind.STRING, value.toString(), start + 1);
  }

  /** After "less than" comes a blank or a parenthesis, or an equals sign and then one of them. */
  private boolean startsIri() {
    int next = at + 1;
    if (next < text.length() && text.charAt(next) == '=') {
      next++;
    }
    return next < text.length() && !isDelimiter(text.charAt(next));
  }

  private Node iri() {
    int start = at;
    int end = at + 1;
    while (end < text.length() && text.charAt(end) != '>') {
      if (Character.isWhitespace(text.charAt(end)) || "<\"".indexOf(text.charAt(end)) >= 0) {
        throw new SlSyntaxException(
            end + 1, "the \">\" that ends the IRI of column " + (start + 1), quoted(end, end + 1));
      }
      end++;
    }
    if (end == text.length()) {
      throw new SlSyntaxException(
          end + 1, "the \">\" that ends the IRI of column " + (start + 1), "the end of the text");
    }
    at = end + 1;
    return new Node.Leaf(Node.Kind.IRI, text.substring(start + 1, end), start + 1);
  }

  private Node word() {
    int start = at;
    while (at < text.length() && !isDelimiter(text.charAt(at))) {
      at++;
    }
    String word = text.substring(start, at);
    if (SYMBOLS.contains(word)) {
      return new Node.Leaf(Node.Kind.WORD, word, start + 1);
    }
    if (isNumber(word)) {
      if (!Double.isFinite(Double.parseDouble(word))) {
        throw new SlSyntaxException(
            start + 1, "a number between -1.8e308 and 1.8e308", "\"" + word + "\"");
      }
      return new Node.Leaf(Node.Kind.NUMBER, word, start + 1);
    }
    Node.Kind kind =
        switch (word.charAt(0)) {
          case '?' -> Node.Kind.VARIABLE;
          case ':' -> Node.Kind.KEYWORD;
          default -> Node.Kind.WORD;
        };
    String name = kind == Node.Kind.WORD ? word : word.substring(1);
    if (!isName(name)) {
      throw new SlSyntaxException(
          start + 1, "a name of letters, digits and . _ - @ % +", "\"" + word + "\"");
    }
    return new Node.Leaf(kind, name, start + 1);
  }

  /** A sign, digits with a point before, between or behind them, an exponent. */
  static boolean isNumber(String word) {
    int start = isSign(word, 0) ? 1 : 0;
    int whole = afterDigits(word, start);
    int end = whole;
    if (end < word.length() && word.charAt(end) == '.') {
      end = afterDigits(word, end + 1);
      if (whole == start && end == whole + 1) {
        return false;
      }
    } else if (whole == start) {
      return false;
    }
    if (end < word.length() && (word.charAt(end) == 'e' || word.charAt(end) == 'E')) {
      int exponent = isSign(word, end + 1) ? end + 2 : end + 1;
      end = afterDigits(word, exponent);
      if (end == exponent) {
        return false;
      }
    }
    return end == word.length();
  }

  private static boolean isSign(String word, int index) {
    return index < word.length() && (word.charAt(index) == '+' || word.charAt(index) == '-');
  }

  private static int afterDigits(String word, int from) {
    int end = from;
    while (end < word.length() && word.charAt(end) >= '0' && word.charAt(end) <= '9') {
      end++;
    }
    return end;
  }

  /** Letters, numbers of any script and underscores; behind the first also other signs. */
  static boolean isName(String word) {
    for (int i = 0; i < word.length(); i += Character.charCount(word.codePointAt(i))) {
      int c = word.codePointAt(i);
      if (!isNameStart(c) && (i == 0 || ".@%+-".indexOf(c) < 0)) {
        return false;
      }
    }
    return !word.isEmpty();
  }

  private static boolean isNameStart(int c) {
    if (Character.isLetterOrDigit(c) || c == '_') {
      return true;
    }
    int type = Character.getType(c);
    return type == Character.LETTER_NUMBER || type == Character.OTHER_NUMBER;
  }

  private void skipSpace() {
    while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
      at++;
    }
  }

  private static boolean isDelimiter(char c) {
    return Character.isWhitespace(c) || c == '(' || c == ')' || c == '"';
  }

  private String quoted(int from, int to) {
    return "\"" + text.substring(from, Math.min(to, text.length())) + "\"";
  }
}
