package org.maestro.language.grammar;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;

/** Reads a form as it is written: {@code (do v)}. */
final class FormText {
  private final String[] tokens;
  private final BiFunction<String, String, GrammarFaultException> fault;
  private int at;

  FormText(String text, BiFunction<String, String, GrammarFaultException> fault) {
    this.tokens = text.replace("(", " ( ").replace(")", " ) ").strip().split("\\s+");
    this.fault = fault;
  }

  Form form() {
    Form form = next();
    if (at < tokens.length) {
      throw fault.apply("has " + tokens[at] + " after its form", "close no bracket twice");
    }
    return form;
  }

  private Form next() {
    if (at == tokens.length) {
      throw fault.apply("ends within a form", "close each bracket");
    }
    String token = tokens[at++];
    if (!token.equals("(")) {
      return Form.leaf(token);
    }
    if (at == tokens.length) {
      throw fault.apply("ends within a form", "close each bracket");
    }
    String head = tokens[at++];
    List<Form> parts = new ArrayList<>();
    while (at < tokens.length && !tokens[at].equals(")")) {
      parts.add(next());
    }
    if (at == tokens.length) {
      throw fault.apply("ends within a form", "close each bracket");
    }
    at++;
    return new Form(head, parts);
  }
}
