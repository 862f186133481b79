package org.maestro.members;

import java.util.List;
import java.util.Objects;
import org.maestro.ontology.home.HomeFaultException;
import org.maestro.ontology.validation.Fault;
import org.maestro.rats.protocol.Verdict;

/** What is made of a member's description, as the member is told. */
public final class DescriptionVerdict {

  private DescriptionVerdict() {}

  /** It can be used as described. */
  public static Verdict accepted(String member, String boot) {
    return new Verdict(member, boot, true, List.of());
  }

  /** The description cannot be read. */
  public static Verdict refused(String member, String boot, RuntimeException why) {
    return why instanceof HomeFaultException found
        ? new Verdict(
            member, boot, false, found.faults().stream().map(DescriptionVerdict::told).toList())
        : refused(member, boot, Objects.requireNonNullElse(why.getMessage(), why.toString()));
  }

  /**
   * The description is right by itself, and cannot be used nevertheless.
   *
   * @param sentence may begin with the member, and end with a cure after a semicolon
   */
  public static Verdict refused(String member, String boot, String sentence) {
    String ofTheMember =
        sentence.startsWith(member + " ") ? sentence.substring(member.length() + 1) : sentence;
    String[] parts = ofTheMember.replaceFirst("\\.$", "").split("; ", 2);
    String cure = parts.length > 1 ? parts[1] : "describe it otherwise";
    return new Verdict(
        member, boot, false, List.of(new Verdict.Fault(0, member, "", parts[0], cure)));
  }

  /** All that is wrong with a description, one sentence after the other. */
  public static String inSentences(RuntimeException why) {
    return why instanceof HomeFaultException found
        ? String.join(". ", found.faults().stream().map(Fault::toString).toList())
        : Objects.requireNonNullElse(why.getMessage(), why.toString());
  }

  private static Verdict.Fault told(Fault fault) {
    return new Verdict.Fault(
        fault.line(), fault.subject(), fault.property(), fault.problem(), fault.cure());
  }
}
