package org.maestro.ontology.reference;

import java.util.List;

/** The words below one heading of the ontology's files. */
record Section(String heading, List<Word> words) {}
