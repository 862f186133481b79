package org.maestro.platform.letters;

import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.XMLFilterImpl;

/**
 * Reads the XML of an envelope that came from another platform: without a document type, so that
 * nobody makes this process open files or grow. JADE makes it by its class name; the parser that
 * JADE would take by itself cannot be made by its name since Java 9.
 */
public final class EnvelopeReader extends XMLFilterImpl {
  /**
   * @throws IllegalStateException when this Java has no XML parser that keeps to such rules
   */
  public EnvelopeReader() {
    SAXParserFactory factory = SAXParserFactory.newInstance();
    // JADE reads the local names of elements, and delivers nothing when there are none.
    factory.setNamespaceAware(true);
    try {
      factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
      factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
      setParent(factory.newSAXParser().getXMLReader());
    } catch (ParserConfigurationException | SAXException e) {
      throw new IllegalStateException(
          "This Java has no XML parser that can refuse document types", e);
    }
  }
}
