package org.maestro.sl;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** Reads a text into nested lists of tokens. */
final class SlReader {

  static final int MAXIMUM_DEPTH = 100;

  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][+-]?\\d+)?");
  private static final Pattern NAME = Pattern.compile("[\\p{L}\\p{N}_][\\p{L}\\p{N}_.@%+-]*");
  private static final List<String> SYMBOLS =
      List.of("=", "<", "<=", ">", ">=", "+", "-", "*", "/");

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
    if (NUMBER.matcher(word).matches()) {
      if (!Double.isFinite(Double.parseDouble(word))) {
        throw new SlSyntaxException(start + 1, "a number below 1.8e308", "\"" + word + "\"");
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
    if (!NAME.matcher(name).matches()) {
      throw new SlSyntaxException(
          start + 1, "a name of letters, digits and . _ - @ % +", "\"" + word + "\"");
    }
    return new Node.Leaf(kind, name, start + 1);
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
