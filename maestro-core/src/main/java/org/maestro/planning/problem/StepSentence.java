package org.maestro.planning.problem;

import java.util.Map;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** A step in words: its feature's sentence with the values put in. */
public final class StepSentence {
  private StepSentence() {}

  public static String of(Operator operator) {
    String sentence = operator.feature().type().sentence();
    if (sentence.isBlank()) {
      sentence = "{self} does " + operator.feature().type().name();
    }
    sentence = sentence.replace("{self}", operator.feature().member());
    for (Map.Entry<String, Term> binding : operator.bindings().entrySet()) {
      String value = SlPrinter.print(binding.getValue());
      sentence = sentence.replace("{" + binding.getKey() + "}", value);
    }
    return sentence;
  }
}
