package org.maestro.sim.parameters;

/**
 * How people and loudspeakers speak, and what a recogniser makes of it.
 *
 * @param wordSeconds from one word of a person to the next; assumed, 200 words a minute
 * @param silenceSeconds of silence after which a recogniser takes a sentence for ended; assumed
 * @param repeatSeconds after which it tells the whole sentence once more, for who has missed it;
 *     assumed
 * @param reviseShare of words that are heard otherwise until the next one makes them clear, 0 to 1;
 *     assumed
 * @param mishearShare of words that stay misheard, 0 to 1; assumed never, as nothing was measured
 * @param confidence in a sentence, 0 to 1; assumed
 * @param spokenWordSeconds of a loudspeaker for each word; assumed, 150 words a minute
 */
public record SpeechData(
    double wordSeconds,
    double silenceSeconds,
    double repeatSeconds,
    double reviseShare,
    double mishearShare,
    double confidence,
    double spokenWordSeconds) {
  static final SpeechData USUAL = new SpeechData(0.3, 0.7, 1, 0.1, 0, 0.9, 0.4);

  public SpeechData {
    PhysicalParameters.positive("speech.wordSeconds", wordSeconds);
    PhysicalParameters.positive("speech.spokenWordSeconds", spokenWordSeconds);
    PhysicalParameters.share("speech.reviseShare", reviseShare);
    PhysicalParameters.share("speech.mishearShare", mishearShare);
    PhysicalParameters.share("speech.confidence", confidence);
  }
}
