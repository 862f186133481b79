package org.maestro.sim.parameters;

/** How people and loudspeakers speak, and what a recogniser makes of it. */
public record SpeechData(
    @Quantity(
            meaning = "time from one word of a person to the next",
            unit = "s",
            source = "assumed: 200 words a minute")
        double wordSeconds,
    @Quantity(
            meaning = "silence after which a recogniser takes a sentence for ended",
            unit = "s",
            source = "assumed")
        double silenceSeconds,
    @Quantity(
            meaning =
                "time after which it tells the whole sentence once more, for who has missed it",
            unit = "s",
            source = "assumed")
        double repeatSeconds,
    @Quantity(
            meaning =
                "share of words that are heard otherwise until the next one makes them clear, 0 to 1",
            unit = "1",
            source = "assumed")
        double reviseShare,
    @Quantity(
            meaning = "share of words that stay misheard, 0 to 1",
            unit = "1",
            source = "assumed: none, as nothing was measured")
        double mishearShare,
    @Quantity(meaning = "confidence in a sentence, 0 to 1", unit = "1", source = "assumed")
        double confidence,
    @Quantity(
            meaning = "time of a loudspeaker for each word",
            unit = "s",
            source = "assumed: 150 words a minute")
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
