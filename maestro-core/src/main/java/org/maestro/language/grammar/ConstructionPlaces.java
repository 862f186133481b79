package org.maestro.language.grammar;

/**
 * What stands in a grammar's patterns for a part of a construction: {@code pattern VpPast = REST
 * PARTICLE+VERB.past}.
 */
public final class ConstructionPlaces {
  /** The verb; after a dot the name of its form. */
  public static final String VERB = "VERB";

  /** What is parted from the verb, and goes before or behind it. */
  public static final String PARTICLE = "PARTICLE";

  /** Who does it; only constructions that tell what happens have one. */
  public static final String SUBJECT = "SUBJECT";

  /** All else that is said. */
  public static final String REST = "REST";

  /** All of it as it stands, where its last word is no verb in a language that has verbs last. */
  public static final String WHOLE = "WHOLE";

  /** All else but the last, where something is said in any words at the end. */
  public static final String BEFORE = "BEFORE";

  /** To whom or what it is done: what fills the first place behind the verb. */
  public static final String OBJECT = "OBJECT";

  /** All else that is said then. */
  public static final String OTHERS = "OTHERS";

  /** What is said in any words, and the word before it. */
  public static final String SAYING = "SAYING";

  /** What the construction means. */
  public static final String FRAME = "FRAME";

  private ConstructionPlaces() {}
}
